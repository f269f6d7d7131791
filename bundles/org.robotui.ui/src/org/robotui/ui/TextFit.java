package org.robotui.ui;

import org.eclipse.swt.graphics.GC;

/** Makes texts fit. Display thread only. */
public final class TextFit {
  private static final String ELLIPSIS = "\u2026";

  private TextFit() {}

  /**
   * Cuts a text at its end where it is too long, and shows that it was cut.
   *
   * @param gc gives the font
   * @param text the text, without line breaks
   * @param width the room, pixels
   * @return the text, or its longest beginning that fits with an ellipsis; empty where not even that fits
   */
  public static String shorten(GC gc, String text, int width) {
    if (gc.textExtent(text).x <= width) {
      return text;
    }
    int fits = 0;
    int over = text.length();
    while (over - fits > 1) {
      int middle = (fits + over) / 2;
      if (gc.textExtent(cut(text, middle)).x <= width) {
        fits = middle;
      } else {
        over = middle;
      }
    }
    return fits == 0 ? "" : cut(text, fits);
  }

  private static String cut(String text, int length) {
    int end = Character.isHighSurrogate(text.charAt(length - 1)) ? length - 1 : length;
    return text.substring(0, end).stripTrailing() + ELLIPSIS;
  }
}
