package org.robotui.ui;

import java.util.Locale;
import java.util.stream.Collectors;
import org.eclipse.swt.graphics.RGB;

/**
 * Writes a picture as SVG, an element after the other; what comes later lies above. Pure; one thread at a time. Lengths
 * are in pixels, from the upper left corner to the right and down.
 */
public final class SvgWriter {
  /** Which part of a text lies at its place. */
  public enum Anchor {
    /** Its beginning. */
    START,
    /** Its middle. */
    MIDDLE,
    /** Its end. */
    END;

    private String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  private final StringBuilder out = new StringBuilder();

  /**
   * A picture that shows its ground alone.
   *
   * @param left where it begins, below 0 for what lies left of the origin
   * @param top the same from above
   * @param width more than 0
   * @param height more than 0
   * @param ground the colour behind all
   */
  public SvgWriter(double left, double top, double width, double height, RGB ground) {
    element("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"%.0f %.0f %.0f %.0f\" font-family=\"sans-serif\">",
        left, top, width, height);
    element("<rect x=\"%.0f\" y=\"%.0f\" width=\"100%%\" height=\"100%%\" fill=\"%s\"/>", left, top, color(ground));
  }

  /**
   * Adds an element as it is.
   *
   * @param format of {@link String#format}; numbers have a point in all countries
   * @param values for it; words of others go through {@link #text} instead
   */
  public void element(String format, Object... values) {
    out.append(String.format(Locale.ROOT, format, values)).append('\n');
  }

  /**
   * Adds a line of text.
   *
   * @param x where its anchor lies
   * @param y where the text stands
   * @param size of the letters
   * @param anchor which part of it lies at x
   * @param color its colour
   * @param words any; nothing of them is markup, and control characters are left out
   */
  public void text(double x, double y, double size, Anchor anchor, RGB color, String words) {
    element("<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>", x, y, size,
        anchor.word(), color(color), escaped(words));
  }

  /**
   * A colour as SVG has it.
   *
   * @param rgb the colour
   * @return for example {@code #4da3ff}
   */
  public static String color(RGB rgb) {
    return String.format(Locale.ROOT, "#%02x%02x%02x", rgb.red, rgb.green, rgb.blue);
  }

  /**
   * Ends the picture.
   *
   * @return the text of the file
   */
  public String end() {
    return out.append("</svg>\n").toString();
  }

  private static String escaped(String words) {
    return words.codePoints().filter(c -> c >= ' ').mapToObj(c -> switch (c) {
      case '<' -> "&lt;";
      case '>' -> "&gt;";
      case '&' -> "&amp;";
      default -> Character.toString(c);
    }).collect(Collectors.joining());
  }
}
