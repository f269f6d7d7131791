package org.robotui.ui.control;

import java.util.List;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** Paints the words of rows whose columns stay where they are while the values change. Display thread. */
public final class RowWords {
  private final Theme theme;
  private final CellPainter cells;

  /**
   * Begins with nothing measured.
   *
   * @param theme fonts and colours
   */
  public RowWords(Theme theme) {
    this.theme = theme;
    cells = new CellPainter(theme);
  }

  /**
   * Paints words from the left of a column, cut where they do not fit.
   *
   * @param gc where to
   * @param row the row
   * @param x where the column begins, pixels from the row's left
   * @param width of the column, pixels
   * @param words what to say; line breaks become blanks
   * @param face the font
   * @param role the colour
   */
  public void text(GC gc, Rectangle row, int x, int width, String words, Face face, Role role) {
    cells.words(gc, column(row, x, width), words, face, theme.color(role), false, false);
  }

  /**
   * Paints a figure at the right of a column, cut where it does not fit.
   *
   * @param gc where to
   * @param row the row
   * @param x where the column begins, pixels from the row's left
   * @param width of the column, pixels
   * @param words what to say
   * @param role the colour
   */
  public void right(GC gc, Rectangle row, int x, int width, String words, Role role) {
    cells.words(gc, column(row, x, width), words, Face.FIGURES, theme.color(role), true, false);
  }

  /**
   * Paints a name from the left of a column. Where it does not fit its middle is left out: names of the same root
   * differ by their ends.
   *
   * @param gc where to
   * @param row the row
   * @param x where the column begins, pixels from the row's left
   * @param width of the column, pixels
   * @param name what to say
   * @param face the font
   * @param role the colour
   */
  public void name(GC gc, Rectangle row, int x, int width, String name, Face face, Role role) {
    cells.name(gc, column(row, x, width), name, face, theme.color(role));
  }

  /**
   * Paints the first figures that fit from the left of a column, else the last, cut.
   *
   * @param gc where to
   * @param row the row
   * @param x where the column begins, pixels from the row's left
   * @param width of the column, pixels
   * @param texts what to say, the longest first; at least one
   * @param role the colour
   */
  public void first(GC gc, Rectangle row, int x, int width, List<String> texts, Role role) {
    String text =
        texts.stream().filter(t -> cells.fits(gc, Face.FIGURES, t, width)).findFirst().orElse(texts.getLast());
    text(gc, row, x, width, text, Face.FIGURES, role);
  }

  /**
   * Paints words in a cell, in the middle of its height, cut where they do not fit.
   *
   * @param gc where to
   * @param cell their place
   * @param words what to say; line breaks become blanks
   * @param face the font
   * @param color the colour
   * @param right whether they end at the cell's right
   * @return how wide they are, pixels
   */
  public int cell(GC gc, Rectangle cell, String words, Face face, Color color, boolean right) {
    return cells.words(gc, cell, words, face, color, right, false);
  }

  private static Rectangle column(Rectangle row, int x, int width) {
    return new Rectangle(row.x + x, row.y, width, row.height);
  }
}
