package org.robotui.ui.control;

import java.util.Locale;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** Paints words in cells, with what was searched marked in them. Display thread. */
final class CellPainter {
  static final int PADDING = 2 * Theme.STEP;

  private static final int DOT = HealthDot.SIZE + 2 * Theme.STEP;
  private static final int CORNER = 4;
  private static final double FOUND = 0.38;

  private final Theme theme;
  private final FittedTexts texts = new FittedTexts();
  private String searched = "";

  CellPainter(Theme theme) {
    this.theme = theme;
  }

  void search(String words) {
    searched = words.strip().toLowerCase(Locale.ROOT);
  }

  <R> void cell(GC gc, Rectangle cell, Column<R> column, R row) {
    Rectangle at = inner(cell);
    if (column.paint().isPresent()) {
      column.paint().get().paint(gc, at, row);
      return;
    }
    column.dot(row)
        .ifPresent(health -> HealthDot.paint(gc, theme, health, at.x + HealthDot.SIZE / 2, at.y + at.height / 2));
    Rectangle words = column.dotted() ? behindDot(at) : at;
    String text = column.fitting(row, whole -> fits(gc, column.face(), whole, words.width));
    words(gc, words, text, column.face(), theme.color(column.role(row)), column.right(), column.highlighted());
  }

  /** Paints words in the middle of a height; returns how wide they are. */
  int words(GC gc, Rectangle at, String text, Face face, Color color, boolean right, boolean marked) {
    gc.setFont(theme.font(face));
    FittedTexts.Fitted fitted = texts.fit(gc, face, line(text), at.width);
    String shown = fitted.shown();
    Point size = fitted.size();
    int x = right ? at.x + at.width - size.x : at.x;
    int y = at.y + (at.height - size.y) / 2;
    if (marked && !searched.isEmpty()) {
      found(gc, shown, x, y, size.y);
    }
    gc.setForeground(color);
    gc.drawText(shown, x, y, true);
    return size.x;
  }

  /** Paints words without their middle where they do not fit. */
  void name(GC gc, Rectangle at, String text, Face face, Color color) {
    gc.setFont(theme.font(face));
    words(gc, at, texts.ends(gc, face, line(text), at.width).shown(), face, color, false, false);
  }

  <R> boolean isCut(GC gc, Rectangle cell, Column<R> column, R row) {
    Rectangle at = column.dotted() ? behindDot(inner(cell)) : inner(cell);
    String text = line(column.text(row));
    return !fits(gc, column.face(), text, at.width);
  }

  boolean fits(GC gc, Face face, String text, int width) {
    gc.setFont(theme.font(face));
    return texts.fit(gc, face, text, width).shown().equals(text);
  }

  private void found(GC gc, String shown, int x, int y, int height) {
    String lower = shown.toLowerCase(Locale.ROOT);
    gc.setBackground(theme.mix(Role.WARNING, Role.PANEL, FOUND));
    for (int at = lower.indexOf(searched); at >= 0; at = lower.indexOf(searched, at + searched.length())) {
      int end = Math.min(shown.length(), at + searched.length());
      int left = gc.textExtent(shown.substring(0, Math.min(at, end))).x;
      int right = gc.textExtent(shown.substring(0, end)).x;
      gc.fillRoundRectangle(x + left, y, right - left, height, CORNER, CORNER);
    }
  }

  static String line(String text) {
    return text.indexOf('\n') < 0 && text.indexOf('\t') < 0 ? text : text.replace('\n', ' ').replace('\t', ' ');
  }

  private static Rectangle inner(Rectangle cell) {
    return new Rectangle(cell.x + PADDING, cell.y, Math.max(0, cell.width - 2 * PADDING), cell.height);
  }

  private static Rectangle behindDot(Rectangle at) {
    return new Rectangle(at.x + DOT, at.y, Math.max(0, at.width - DOT), at.height);
  }
}
