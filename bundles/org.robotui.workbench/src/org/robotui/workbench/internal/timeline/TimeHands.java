package org.robotui.workbench.internal.timeline;

import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;

/**
 * The mouse over the time: the first button seeks, pressed and dragged; the middle one moves what is shown, and so does
 * the wheel; with Ctrl it zooms at the pointer. Display thread only.
 */
final class TimeHands {
  private static final double ZOOM = 1.25;
  private static final int WHEEL_POINTS = 40;
  private static final int LINES = 3;

  private final Control control;
  private final BarState bar;
  private final Runnable changed;
  private final NewestSeek seek;
  private final Predicate<Event> taken;
  private boolean scrubbing;
  private OptionalInt panned = OptionalInt.empty();

  /**
   * Hands on a control.
   *
   * @param control where
   * @param bar what it shows
   * @param changed is run when something is to be painted anew
   * @param seek goes to a time
   * @param taken whether a press of the first button is meant for something that lies over the time; else it seeks
   */
  TimeHands(Control control, BarState bar, Runnable changed, NewestSeek seek, Predicate<Event> taken) {
    this.control = control;
    this.bar = bar;
    this.changed = changed;
    this.seek = seek;
    this.taken = taken;
    listen(SWT.MouseDown, this::down);
    listen(SWT.MouseMove, this::move);
    listen(SWT.MouseEnter, this::move);
    listen(SWT.MouseUp, this::up);
    listen(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    listen(SWT.MouseExit, e -> point(OptionalInt.empty()));
    listen(SWT.MouseVerticalWheel, this::wheel);
    listen(SWT.MouseHorizontalWheel, e -> pan(-e.count * WHEEL_POINTS / LINES));
  }

  private void listen(int type, Consumer<Event> what) {
    control.addListener(type, what::accept);
  }

  TimeScale scale() {
    return bar.scale(control.getSize().x);
  }

  private boolean isTime(int x) {
    TimeScale scale = scale();
    return x >= scale.left() - BarGrip.REACH && x <= scale.left() + scale.width() + BarGrip.REACH;
  }

  private void down(Event event) {
    control.setFocus();
    if (event.button == 2) {
      panned = OptionalInt.of(event.x);
    } else if (event.button == 1 && isTime(event.x) && !taken.test(event)) {
      scrubbing = true;
      seek.to(scale().time(event.x));
    }
  }

  /** What counts is where it was let go: on a busy desktop the last move may not have come. */
  private void up(Event event) {
    if (scrubbing && event.button == 1) {
      seek.to(scale().time(event.x));
    }
    scrubbing = false;
    panned = OptionalInt.empty();
  }

  private void move(Event event) {
    point(isTime(event.x) ? OptionalInt.of(event.x) : OptionalInt.empty());
    if (scrubbing) {
      seek.to(scale().time(event.x));
    } else if (panned.isPresent()) {
      int by = panned.getAsInt() - event.x;
      panned = OptionalInt.of(event.x);
      pan(by);
    }
  }

  private void point(OptionalInt x) {
    if (!x.equals(bar.pointer())) {
      bar.point(x, scale());
      changed.run();
    }
  }

  private void wheel(Event event) {
    if ((event.stateMask & SWT.MOD1) != 0) {
      zoom(event.x, Math.pow(ZOOM, (double) event.count / LINES));
      event.doit = false;
    } else if (isTime(event.x) && event.doit) {
      pan(-event.count * WHEEL_POINTS / LINES);
    }
  }

  /** Shows less or more around a place. */
  void zoom(int x, double factor) {
    bar.zoom(scale().zoomed(x, factor, bar.all()));
    changed.run();
  }

  private void pan(int points) {
    bar.zoom(scale().panned(points, bar.all()));
    changed.run();
  }
}
