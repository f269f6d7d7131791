package org.robotui.workbench.internal.timeline;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.replay.TimeRange;

/** The ends of what is played, taken and dragged. Display thread only. */
final class BarGrip {
  /** How far beside an end it can still be taken, points. */
  static final int REACH = 6;

  private final Control control;
  private final BarState bar;
  private final LiveTimeline live;
  private Optional<Boolean> held = Optional.empty();

  BarGrip(Control control, BarState bar, LiveTimeline live) {
    this.control = control;
    this.bar = bar;
    this.live = live;
    control.addListener(SWT.MouseMove, this::drag);
    control.addListener(SWT.MouseUp, e -> held = Optional.empty());
  }

  /** Whether a press takes one of the ends: outside of what is played, so that seeking to an end is possible. */
  boolean take(Event event) {
    held = at(event);
    return held.isPresent();
  }

  private Optional<Boolean> at(Event event) {
    TimeScale scale = bar.scale(control.getSize().x);
    if (event.y < StripPaint.BODY || event.y > StripPaint.MARKS) {
      return Optional.empty();
    }
    Optional<TimeRange> played = TimelineMoves.played(bar.state());
    int left = played.map(p -> scale.x(p.start()) - event.x).orElse(Integer.MIN_VALUE);
    int right = played.map(p -> event.x - scale.x(p.end())).orElse(Integer.MIN_VALUE);
    return right >= 0 && right <= REACH ? Optional.of(false)
        : left >= 0 && left <= REACH ? Optional.of(true) : Optional.empty();
  }

  private void drag(Event event) {
    TimeScale scale = bar.scale(control.getSize().x);
    held.ifPresent(start -> live.timeline()
        .ifPresent(t -> new TimelineMoves(t).limit(start, scale.time(event.x))));
    boolean near = held.isPresent() || at(event).isPresent();
    control.setCursor(near ? control.getDisplay().getSystemCursor(SWT.CURSOR_SIZEWE) : null);
  }
}
