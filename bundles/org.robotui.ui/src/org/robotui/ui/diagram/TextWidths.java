package org.robotui.ui.diagram;

import java.util.Arrays;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Theme;

/**
 * How wide words are, so that boxes are laid out beside the display thread. Immutable. What a title does not find room
 * for is shortened when it is painted.
 */
public final class TextWidths {
  private static final int FIRST = 32;
  private static final int LAST = 126;
  private static final double USUAL = 0.56;

  private final double[] widths;

  private TextWidths(double[] widths) {
    this.widths = widths;
  }

  /**
   * Without a display: as wide as usual letters are.
   *
   * @return about right
   */
  public static TextWidths estimate() {
    double[] widths = new double[LAST - FIRST + 1];
    Arrays.fill(widths, USUAL * Face.BODY.pixels());
    return new TextWidths(widths);
  }

  /**
   * As a theme's letters are. Display thread.
   *
   * @param control where they are drawn
   * @param theme fonts
   * @return exact for letters of ASCII
   */
  public static TextWidths of(Control control, Theme theme) {
    GC gc = new GC(control);
    gc.setFont(theme.font(Face.BODY));
    double[] widths = new double[LAST - FIRST + 1];
    for (int i = 0; i < widths.length; i++) {
      // Ten at once: the extent is in whole points.
      widths[i] = gc.textExtent(Character.toString(FIRST + i).repeat(10)).x / 10.0;
    }
    gc.dispose();
    return new TextWidths(widths);
  }

  /**
   * The width of a title.
   *
   * @param text its words
   * @return points
   */
  public double title(String text) {
    return text.chars().mapToDouble(this::width).sum();
  }

  /**
   * The width of a note.
   *
   * @param text its words
   * @return points
   */
  public double note(String text) {
    return title(text) * Face.SMALL.pixels() / Face.BODY.pixels();
  }

  private double width(int c) {
    return c >= FIRST && c <= LAST ? widths[c - FIRST] : Face.BODY.pixels() * USUAL;
  }
}
