package org.robotui.uic.log.internal.view;

import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.data.status.Severity;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.RowLook;
import org.robotui.uic.log.internal.model.Entry;
import org.robotui.uic.log.internal.model.LogLine;
import org.robotui.uic.log.internal.model.Search;
import org.robotui.uic.log.internal.model.Wording;

/** Paints a row of the log: time, level, node, message, place. What was searched is marked. Display thread. */
final class LineLook implements RowLook<LogLine> {
  private static final int ROW = 24;
  private static final int GAP = 12;
  private static final int TIME = 98;
  private static final int LEVEL = 58;
  private static final int NARROWEST_NODE = 90;
  private static final int WIDEST_NODE = 200;
  private static final double NODE_SHARE = 0.18;
  private static final int PLACE = 190;
  private static final int ROOM_FOR_NODE = 480;
  private static final int ROOM_FOR_PLACE = 960;
  private static final int ROOM_FOR_TIME = 340;
  private static final int PAINTED = 600;
  private static final int CORNER = 4;
  private static final double TINT = 0.10;
  private static final double FOUND = 0.38;

  private final Theme theme;
  private final Wording wording;
  private Search search = Search.ALL;

  LineLook(Theme theme, Wording wording) {
    this.theme = theme;
    this.wording = wording;
  }

  void search(Search next) {
    search = next;
  }

  @Override
  public Object key(LogLine line) {
    return line.id();
  }

  @Override
  public String text(LogLine line) {
    return wording.text(line);
  }

  @Override
  public int height() {
    return ROW;
  }

  @Override
  public String hint(GC gc, Rectangle at, LogLine line, int x) {
    return "";
  }

  @Override
  public void paint(GC gc, Rectangle at, LogLine line) {
    Entry entry = line.last();
    tint(gc, at, entry.severity());
    int left = at.x + Theme.EDGE;
    int right = at.x + at.width - Theme.EDGE;
    if (at.width >= ROOM_FOR_TIME) {
      words(gc, at, left, TIME, wording.time(entry), Face.FIGURES, theme.color(Role.DIM), false);
      left += TIME + GAP;
    }
    level(gc, at, left, entry.severity());
    left += LEVEL + GAP;
    if (at.width >= ROOM_FOR_NODE) {
      int node = Math.clamp((int) (at.width * NODE_SHARE), NARROWEST_NODE, WIDEST_NODE);
      words(gc, at, left, node, entry.origin(), Face.BODY, theme.color(Role.DIM), true);
      left += node + GAP;
    }
    if (at.width >= ROOM_FOR_PLACE) {
      words(gc, at, right - PLACE, PLACE, entry.location(), Face.SMALL, theme.color(Role.DIM), true);
      right -= PLACE + GAP;
    }
    right -= count(gc, at, right, line.count());
    Role ink = entry.severity() == Severity.DEBUG ? Role.DIM : Role.TEXT;
    words(gc, at, left, right - left, message(entry), Face.BODY, theme.color(ink), true);
  }

  private static String message(Entry entry) {
    String first = entry.firstLine(PAINTED).replace('\t', ' ').replace('\r', ' ');
    return entry.more() ? first + " \u21b5" : first;
  }

  /** What is broken is seen while scrolling fast. */
  private void tint(GC gc, Rectangle at, Severity severity) {
    if (severity.compareTo(Severity.ERROR) >= 0) {
      Color ground = gc.getBackground();
      gc.setAlpha((int) (255 * TINT));
      gc.setBackground(theme.color(Role.BAD));
      gc.fillRectangle(at);
      gc.setAlpha(255);
      gc.setBackground(ground);
    }
  }

  private void level(GC gc, Rectangle at, int x, Severity severity) {
    Severities.dot(severity)
        .ifPresent(health -> HealthDot.paint(gc, theme, health, x + HealthDot.SIZE / 2, at.y + at.height / 2));
    int lead = HealthDot.SIZE + 6;
    Face face = severity == Severity.FATAL ? Face.BODY_STRONG : Face.BODY;
    words(gc, at, x + lead, LEVEL - lead + 6, Wording.word(severity), face, theme.color(Severities.role(severity)),
        false);
  }

  private int count(GC gc, Rectangle at, int right, int count) {
    if (count == 1) {
      return 0;
    }
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    String text = "\u00d7" + count;
    Point size = gc.textExtent(text);
    int width = size.x + 2 * Theme.STEP;
    gc.setBackground(theme.mix(Role.TEXT, Role.PANEL, TINT));
    gc.fillRoundRectangle(right - width, at.y + (at.height - size.y) / 2 - 1, width, size.y + 2, 2 * CORNER,
        2 * CORNER);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(text, right - width + Theme.STEP, at.y + (at.height - size.y) / 2, true);
    return width + GAP;
  }

  private void words(GC gc, Rectangle at, int x, int width, String text, Face face, Color color, boolean marked) {
    gc.setFont(theme.font(face));
    String shown = TextFit.shorten(gc, text, Math.max(0, width));
    int height = gc.textExtent(shown).y;
    int y = at.y + (at.height - height) / 2;
    if (marked && search.active()) {
      search.spans(text).forEach(span -> mark(gc, shown, span, new Rectangle(x, y, width, height)));
    }
    gc.setForeground(color);
    gc.drawText(shown, x, y, true);
  }

  private void mark(GC gc, String shown, Search.Span span, Rectangle at) {
    int start = Math.min(span.start(), shown.length());
    int end = Math.min(span.end(), shown.length());
    if (end > start) {
      int left = gc.textExtent(shown.substring(0, start)).x;
      int right = gc.textExtent(shown.substring(0, end)).x;
      gc.setBackground(theme.mix(Role.WARNING, Role.PANEL, FOUND));
      gc.fillRoundRectangle(at.x + left, at.y, right - left, at.height, CORNER, CORNER);
    }
  }
}
