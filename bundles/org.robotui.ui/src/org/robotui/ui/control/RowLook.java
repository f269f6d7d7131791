package org.robotui.ui.control;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;

/**
 * How the rows of a {@link RowList} look. All on the display thread, but for {@link #key} and {@link #text}, which are
 * pure.
 *
 * @param <R> a row, immutable
 */
public interface RowLook<R> {
  /** The usual height of a row, points. */
  int HEIGHT = 26;

  /**
   * What identifies a row, so that it stays selected while others come and go.
   *
   * @param row the row
   * @return a key with equals and hashCode, unique in the list
   */
  Object key(R row);

  /**
   * All of a row as text, for the clipboard and for screen readers.
   *
   * @param row the row
   * @return its cells, separated by tabs
   */
  String text(R row);

  /**
   * Paints one row; hover and selection are painted already.
   *
   * @param gc where to paint
   * @param at its place
   * @param row the row
   */
  void paint(GC gc, Rectangle at, R row);

  /**
   * The tooltip at a place of a row.
   *
   * @param gc to measure with
   * @param at the row's place
   * @param row the row
   * @param x where the pointer is, in the coordinates of {@code at}
   * @return the words, empty for none
   */
  default String hint(GC gc, Rectangle at, R row, int x) {
    return "";
  }

  /**
   * The height of all rows.
   *
   * @return points
   */
  default int height() {
    return HEIGHT;
  }
}
