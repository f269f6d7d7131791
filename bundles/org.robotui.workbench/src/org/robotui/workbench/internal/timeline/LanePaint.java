package org.robotui.workbench.internal.timeline;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Track;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.timeline.LaneDensity.TrackLane;
import org.robotui.workbench.internal.timeline.LaneRows.Row;

/** Paints a row of the recordings: its name at the left, what lies where at the right. */
record LanePaint(Theme theme, BarState bar, LiveTimeline live, TrackAnalysis analysis) {
  private static final int INDENT = 26;
  private static final int SMALL_ICON = 12;
  private static final int GAP = 8;

  void paint(GC gc, Row row, int y, Rectangle area, boolean focused) {
    TimeScale scale = bar.scale(area.width);
    if (focused) {
      gc.setBackground(theme.mix(Role.ACCENT, Role.PANEL, 0.15));
      gc.fillRectangle(0, y, scale.left() - Theme.STEP, LaneRows.HEIGHT);
    }
    switch (row) {
      case Row.Head head -> head(gc, head, y, scale);
      case Row.Topic topic -> topic(gc, topic, y, scale);
    }
  }

  private void head(GC gc, Row.Head head, int y, TimeScale scale) {
    Track track = head.track();
    gc.setForeground(theme.color(Role.DIM));
    Icons.paint(gc, head.folded() ? Icon.CLOSED : Icon.OPEN, Theme.STEP + 2, y + 5, SMALL_ICON);
    int right = scale.left() - GAP;
    if (!track.problems().isEmpty()) {
      right = write(gc, Face.SMALL, Role.WARNING, "\u26a0", right, y) - GAP;
    }
    if (track.offset() != 0) {
      right = write(gc, Face.SMALL_FIGURES, Role.ACCENT, offset(track), right, y) - GAP;
    }
    int left = text(gc, Face.BODY_STRONG, Role.TEXT, track.id().robot(), INDENT - 4, y, right);
    Optional<String> doing = analysis.doing(track.id()).map(words -> words + "\u2026");
    text(gc, Face.SMALL, doing.isPresent() ? Role.ACCENT : Role.DIM,
        doing.orElse(track.file().getFileName().toString()), left + GAP, y, right);
    span(gc, track, y, scale);
  }

  static String offset(Track track) {
    return (track.offset() > 0 ? "+" : "") + TimeWords.offset(track.offset()).replace('-', '\u2212') + "\u00a0s";
  }

  private void span(GC gc, Track track, int y, TimeScale scale) {
    gc.setBackground(theme.mix(Role.TEXT, Role.PANEL, 0.2));
    Optional<int[]> seen = within(scale, track.span());
    seen.ifPresent(x -> gc.fillRoundRectangle(x[0], y + 8, Math.max(2, x[1] - x[0]), 6, 4, 4));
  }

  private void topic(GC gc, Row.Topic topic, int y, TimeScale scale) {
    boolean stepped = live.stepped().filter(topic.id()::equals).isPresent();
    TrackLane of = topic.of();
    int right = write(gc, Face.SMALL_FIGURES, Role.DIM, shortCount(of), scale.left() - GAP, y) - GAP;
    int left = text(gc, stepped ? Face.SMALL_STRONG : Face.SMALL, stepped ? Role.ACCENT : Role.TEXT,
        of.lane().topic(), INDENT, y, right);
    text(gc, Face.SMALL, Role.DIM, of.lane().type(), left + GAP, y, right);
    gc.setForeground(theme.mix(Role.LINE, Role.PANEL, 0.7));
    within(scale, of.track().span())
        .ifPresent(x -> gc.drawLine(x[0], y + LaneRows.HEIGHT - 3, x[1], y + LaneRows.HEIGHT - 3));
    TimePaint.density(gc, LaneDensity.columns(List.of(of), scale), scale.left(), y + 4, LaneRows.HEIGHT - 7,
        theme.color(stepped ? Role.ACCENT : Role.GOOD));
  }

  private static String shortCount(TrackLane of) {
    return of.lane().count() < 0 ? "\u2026" : Long.toString(of.lane().count());
  }

  private static Optional<int[]> within(TimeScale scale, TimeRange span) {
    boolean seen = span.end() >= scale.shown().start() && span.start() <= scale.shown().end();
    return seen ? Optional.of(new int[]{scale.x(scale.shown().nearest(span.start())),
        scale.x(scale.shown().nearest(span.end()))}) : Optional.empty();
  }

  /** Ends at the right; answers where it begins. */
  private int write(GC gc, Face face, Role role, String words, int right, int y) {
    gc.setFont(theme.font(face));
    int left = right - gc.textExtent(words).x;
    gc.setForeground(theme.color(role));
    gc.drawText(words, left, y + (LaneRows.HEIGHT - gc.textExtent(words).y) / 2, true);
    return left;
  }

  /** Begins at the left and is shortened where it has to; answers where it ends. */
  private int text(GC gc, Face face, Role role, String words, int left, int y, int right) {
    gc.setFont(theme.font(face));
    String fitting = right - left < 16 ? "" : TextFit.shorten(gc, words, right - left);
    gc.setForeground(theme.color(role));
    gc.drawText(fitting, left, y + (LaneRows.HEIGHT - gc.textExtent("X").y) / 2, true);
    return left + gc.textExtent(fitting).x;
  }
}
