package org.robotui.workbench.internal.timeline;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.Track;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.PopupMenu;
import org.robotui.workbench.internal.timeline.LaneDensity.TrackLane;

/** The slider: all of the time, or what is zoomed into. Display thread only. */
final class TimeStrip {
  private static final double KEY_ZOOM = 1.5;

  private final PaintedCanvas canvas;
  private final BarState bar;
  private final LiveTimeline live;
  private final Runnable changed;
  private final StripPaint paint;
  private final BarGrip grip;
  private final TimeHands hands;
  private List<Track> counted = List.of();
  private Optional<TimeScale> countedFor = Optional.empty();
  private double[] columns = {};

  /** A strip of what a bar shows; {@code changed} is run when something is to be painted anew. */
  TimeStrip(Composite parent, Theme theme, BarState bar, LiveTimeline live, NewestSeek seek, Runnable changed) {
    this.bar = bar;
    this.live = live;
    this.changed = changed;
    paint = new StripPaint(theme, bar);
    canvas = new PaintedCanvas(parent, SWT.NONE, theme, Role.PANEL, (gc, area) -> {
      count(area);
      paint.paint(gc, area, columns, isFocused());
    });
    grip = new BarGrip(canvas, bar, live);
    hands = new TimeHands(canvas, bar, changed, seek, this::isTaken);
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.MenuDetect, this::menu);
    canvas.addListener(SWT.FocusIn, e -> canvas.requestPaint());
    canvas.addListener(SWT.FocusOut, e -> canvas.requestPaint());
    TimeVoice.slider(canvas, "Timeline", () -> TimeWords.seconds(bar.state().position() - bar.all().start()));
  }

  PaintedCanvas canvas() {
    return canvas;
  }

  private boolean isFocused() {
    return canvas().isFocusControl();
  }

  /** Counting anew takes as long as all the rest, and is needed only when something else is shown. */
  private void count(Rectangle area) {
    TimeScale scale = bar.scale(area.width);
    if (!countedFor.equals(Optional.of(scale)) || counted != bar.tracks()) {
      counted = bar.tracks();
      countedFor = Optional.of(scale);
      columns = LaneDensity.columns(TrackLane.all(counted), scale);
    }
  }

  private boolean isTaken(Event event) {
    Optional<Bookmark> mark = event.y < StripPaint.MARKS ? Optional.empty()
        : StripPaint.mark(bar.state().bookmarks(), hands.scale(), event.x);
    mark.ifPresent(m -> live.timeline().ifPresent(t -> t.seek(m.time())));
    return mark.isPresent() || grip.take(event);
  }

  private void key(Event event) {
    live.timeline().ifPresent(t -> key(event, new TimelineMoves(t)));
  }

  private void key(Event event, TimelineMoves moves) {
    boolean far = (event.stateMask & SWT.MOD1) != 0;
    TimeScale scale = hands.scale();
    switch (event.keyCode) {
      case ' ' -> moves.toggle();
      case SWT.ARROW_LEFT -> move(far, false, moves);
      case SWT.ARROW_RIGHT -> move(far, true, moves);
      case SWT.ARROW_UP -> moves.faster(true);
      case SWT.ARROW_DOWN -> moves.faster(false);
      case SWT.PAGE_UP -> moves.jump(-10);
      case SWT.PAGE_DOWN -> moves.jump(10);
      case SWT.HOME -> moves.end(false);
      case SWT.END -> moves.end(true);
      case '+', SWT.KEYPAD_ADD -> hands.zoom(scale.x(bar.state().position()), KEY_ZOOM);
      case '-', SWT.KEYPAD_SUBTRACT -> hands.zoom(scale.x(bar.state().position()), 1 / KEY_ZOOM);
      case '0' -> fit();
      default -> {}
    }
  }

  private void move(boolean second, boolean forward, TimelineMoves moves) {
    if (second) {
      moves.jump(forward ? 1 : -1);
    } else {
      live.step(forward);
    }
  }

  private void fit() {
    bar.zoom(bar.all());
    changed.run();
  }

  private void menu(Event event) {
    live.timeline().ifPresent(t -> menu(event, t));
  }

  private void menu(Event event, Timeline timeline) {
    boolean byKey = event.detail == SWT.MENU_KEYBOARD;
    Point at = canvas.toControl(event.x, event.y);
    long time = byKey ? bar.state().position() : bar.all().nearest(hands.scale().time(at.x));
    BookmarkMenu bookmarks = new BookmarkMenu(canvas, bar, timeline);
    TimelineMoves moves = new TimelineMoves(timeline);
    PopupMenu menu = new PopupMenu(canvas, changed);
    Consumer<Bookmark> those = mark -> bookmarks.of(menu, mark);
    StripPaint.mark(bar.state().bookmarks(), hands.scale(), byKey ? hands.scale().x(time) : at.x).ifPresent(those);
    menu.line();
    menu.push("Add Bookmark Here", () -> bookmarks.add(time));
    menu.line();
    menu.push("Play from Here On", () -> moves.limit(true, time));
    menu.push("Play until Here", () -> moves.limit(false, time));
    menu.push("Play All", bar.state().range().isPresent(), () -> timeline.range(Optional.empty()));
    menu.line();
    menu.push("Show What Is Played", bar.state().range().isPresent(),
        () -> bar.state().range().ifPresent(bar::zoom));
    menu.push("Show All of the Time\t0", bar.isZoomed(), this::fit);
    menu.open(new Point(event.x, event.y));
  }
}
