package org.robotui.ui;

import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.eclipse.swt.graphics.GC;

/** Makes texts fit. Display thread only. */
public final class TextFit {
  private static final String ELLIPSIS = "\u2026";

  /** More cannot be seen, and measuring a text of megabytes takes long. */
  private static final int CHARACTERS_PER_PIXEL = 2;

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
    return longest(gc, text, width, length -> cut(text, length));
  }

  /**
   * Cuts a text at its beginning where it is too long: of a path the end says most.
   *
   * @param gc gives the font
   * @param text the text, without line breaks
   * @param width the room, pixels
   * @return the text, or its longest end that fits with an ellipsis; empty where not even that fits
   */
  public static String shortenFront(GC gc, String text, int width) {
    return longest(gc, text, width, length -> cutFront(text, length));
  }

  /** Measures few texts, whatever the length is: each half as far from the right one as the one before. */
  private static String longest(GC gc, String text, int width, IntFunction<String> cut) {
    int visible = Math.min(text.length(), CHARACTERS_PER_PIXEL * Math.max(1, width));
    if (visible == text.length() && gc.textExtent(text).x <= width) {
      return text;
    }
    int fits = 0;
    int over = visible;
    while (over - fits > 1) {
      int middle = (fits + over) / 2;
      if (gc.textExtent(cut.apply(middle)).x <= width) {
        fits = middle;
      } else {
        over = middle;
      }
    }
    return fits == 0 ? "" : cut.apply(fits);
  }

  /**
   * Takes the middle out of a text that is too long: names of the same root differ by their ends.
   *
   * @param gc gives the font
   * @param text the text, without line breaks
   * @param width the room, pixels
   * @return the text, or its beginning and its end with an ellipsis between; empty where not even that fits
   */
  public static String inTheMiddle(GC gc, String text, int width) {
    int visible = CHARACTERS_PER_PIXEL * Math.max(1, width);
    if (text.length() <= visible && gc.textExtent(text).x <= width) {
      return text;
    }
    return IntStream.iterate(Math.min(text.length() - 1, visible), length -> length > 0, length -> length - 1)
        .mapToObj(length -> ends(text, length)).filter(cut -> gc.textExtent(cut).x <= width).findFirst().orElse("");
  }

  private static String ends(String text, int length) {
    int end = (length + 1) / 2;
    return text.substring(0, length - end) + ELLIPSIS + text.substring(text.length() - end);
  }

  private static String cutFront(String text, int length) {
    int start = text.length() - length;
    return ELLIPSIS + text.substring(Character.isLowSurrogate(text.charAt(start)) ? start + 1 : start).stripLeading();
  }

  private static String cut(String text, int length) {
    int end = Character.isHighSurrogate(text.charAt(length - 1)) ? length - 1 : length;
    return text.substring(0, end).stripTrailing() + ELLIPSIS;
  }
}
