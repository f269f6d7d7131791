package org.robotui.workbench.internal.timeline;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.TimeRange;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.timeline.ElapsedTicks.Tick;
import org.robotui.workbench.internal.timeline.LaneDensity.Counted;
import org.robotui.workbench.internal.timeline.LaneDensity.TrackLane;

/** Paints the strip: round times, how many messages lie where, what is played, bookmarks and the position. */
record StripPaint(Theme theme, BarState bar) {
  /** From the top: the labels, the body with the messages, the bookmarks. */
  static final int BODY = 16;
  static final int MARKS = 38;
  static final int HEIGHT = 48;

  private static final int TICK_DISTANCE = 84;
  private static final int FLAG = 4;
  private static final int FOUND = 4;
  private static final int GRIP = 5;

  void paint(GC gc, Rectangle area, double[] columns, boolean focused) {
    TimeScale scale = bar.scale(area.width);
    Rectangle time = new Rectangle(scale.left(), 0, scale.width(), area.height);
    gc.setBackground(theme.color(Role.GROUND));
    gc.fillRectangle(time.x, BODY, time.width, MARKS - BODY);
    ticks(gc, scale, time);
    gc.setClipping(time.x - GRIP, 0, time.width + 2 * GRIP, area.height);
    TimePaint.density(gc, columns, time.x, BODY + 2, MARKS - BODY - 2, theme.mix(Role.ACCENT, Role.GROUND, 0.55));
    TimelineMoves.played(bar.state()).ifPresent(played -> range(gc, scale, played));
    found(gc, scale);
    bar.state().bookmarks().forEach(mark -> flag(gc, scale, mark));
    position(gc, scale);
    bar.pointer().ifPresent(x -> pointer(gc, scale, x, time));
    bar.elsewhere(scale).ifPresent(x -> pointer(gc, scale, x, time));
    gc.setClipping((Rectangle) null);
    if (focused) {
      gc.setForeground(theme.color(Role.ACCENT));
      gc.drawRectangle(time.x - GRIP - 1, BODY - 1, time.width + 2 * GRIP + 1, MARKS - BODY + 1);
    }
  }

  private void ticks(GC gc, TimeScale scale, Rectangle time) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    int free = 0;
    for (Tick tick : ElapsedTicks.of(scale, bar.all().start(), TICK_DISTANCE)) {
      int x = scale.x(tick.time());
      gc.setForeground(theme.color(Role.LINE));
      gc.drawLine(x, BODY - 3, x, MARKS);
      Point size = gc.textExtent(tick.label());
      int left = Math.clamp(x - size.x / 2, time.x, Math.max(time.x, time.x + time.width - size.x));
      if (left >= free) {
        gc.setForeground(theme.color(Role.DIM));
        gc.drawText(tick.label(), left, 0, true);
        free = left + size.x + Theme.STEP;
      }
    }
  }

  /** What is not played is veiled; both ends can be taken by the grips. */
  private void range(GC gc, TimeScale scale, TimeRange played) {
    int from = scale.x(played.start());
    int to = scale.x(played.end());
    gc.setBackground(theme.color(Role.PANEL));
    gc.setAlpha(190);
    gc.fillRectangle(scale.left(), BODY, Math.max(0, from - scale.left()), MARKS - BODY);
    gc.fillRectangle(to, BODY, Math.max(0, scale.left() + scale.width() - to), MARKS - BODY);
    gc.setAlpha(255);
    gc.setBackground(theme.color(bar.state().range().isPresent() ? Role.ACCENT : Role.DIM));
    gc.fillRoundRectangle(from - GRIP + 1, BODY, GRIP, MARKS - BODY, 3, 3);
    gc.fillRoundRectangle(to, BODY, GRIP, MARKS - BODY, 3, 3);
  }

  /** Times at which something was so: a line at the top of the body, at least so wide that it is seen. */
  private void found(GC gc, TimeScale scale) {
    gc.setBackground(theme.color(Role.WARNING));
    int right = scale.left() + scale.width();
    for (FoundRow row : bar.found()) {
      int from = Math.max(scale.left(), scale.x(row.range().start()) - 1);
      int to = Math.min(right, Math.max(scale.x(row.range().end()), scale.x(row.range().start()) + 1));
      if (to >= from) {
        gc.fillRectangle(from, BODY, to - from + 1, FOUND);
      }
    }
  }

  private void flag(GC gc, TimeScale scale, Bookmark mark) {
    int x = scale.x(mark.time());
    TimePaint.line(gc, scale, x, BODY, MARKS, theme.color(Role.PLAN), 1);
    if (x >= scale.left() && x <= scale.left() + scale.width()) {
      gc.setBackground(theme.color(Role.PLAN));
      gc.fillPolygon(new int[]{x, MARKS, x - FLAG, HEIGHT - 3, x + FLAG, HEIGHT - 3});
    }
  }

  private void position(GC gc, TimeScale scale) {
    int x = scale.x(bar.state().position());
    TimePaint.line(gc, scale, x, BODY - 2, MARKS, theme.color(Role.TEXT), 2);
    if (x >= scale.left() && x <= scale.left() + scale.width()) {
      gc.setBackground(theme.color(Role.TEXT));
      gc.fillPolygon(new int[]{x - GRIP, BODY - 6, x + GRIP, BODY - 6, x, BODY + 1});
    }
  }

  private void pointer(GC gc, TimeScale scale, int x, Rectangle time) {
    TimePaint.line(gc, scale, x, BODY, MARKS, theme.color(Role.DIM), 1);
    TimePaint.hint(gc, theme, hint(scale, x), x, 0, time);
  }

  /** What lies where the pointer is: a bookmark with its note, or how many messages. */
  String hint(TimeScale scale, int x) {
    long at = scale.time(x);
    String when = TimeWords.seconds(at - bar.all().start());
    return mark(bar.state().bookmarks(), scale, x).map(m -> TimeWords.seconds(m.time() - bar.all().start()) + "  "
        + (m.note().isEmpty() ? "bookmark" : m.note()))
        .or(() -> found(bar.found(), at).map(row -> when + "  " + row.words()))
        .orElseGet(() -> when + "  " + counted(TrackLane.all(bar.tracks()), scale, at));
  }

  static String counted(List<TrackLane> lanes, TimeScale scale, long at) {
    if (lanes.stream().allMatch(l -> l.lane().density().isEmpty())) {
      return "not counted yet";
    }
    Counted counted = LaneDensity.count(lanes, new TimeRange(at, at + scale.point()));
    return TimeWords.messages(counted.messages()) + (counted.messages() == 0 ? ""
        : " in " + TimeWords.seconds(counted.parts().length()));
  }

  /** What was so at a time. */
  private static Optional<FoundRow> found(List<FoundRow> rows, long at) {
    return rows.stream().filter(row -> row.range().start() <= at && at <= row.range().end()).findFirst();
  }

  /** The bookmark at a place, where there is one. */
  static Optional<Bookmark> mark(List<Bookmark> marks, TimeScale scale, int x) {
    return marks.stream().filter(m -> Math.abs(scale.x(m.time()) - x) <= FLAG)
        .min(Comparator.comparingInt(m -> Math.abs(scale.x(m.time()) - x)));
  }
}
