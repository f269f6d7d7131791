package org.robotui.ui;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;

/**
 * What colours mean: a bar of all of them with numbers beside it, the greatest on top.
 *
 * @param title what the numbers are
 * @param unit of the numbers; empty where none is known
 * @param low the number of the first colour
 * @param high the number of the last colour, not less
 * @param shades the colours
 */
public record ColorBar(String title, String unit, double low, double high, Shades shades) {
  private static final int THICK = 12;
  private static final int TICKS = 4;
  private static final double DIGITS = 1.3;
  private static final int MOST_DECIMALS = 6;
  private static final int BYTE = 0xff;

  /** Colours from the first to the last. */
  @FunctionalInterface
  public interface Shades {
    /**
     * A colour.
     *
     * @param share where between the first and the last, 0 to 1
     * @return red, green and blue, a byte each
     */
    int rgb(double share);
  }

  /**
   * How wide a bar and its numbers are.
   *
   * @param gc with the font of the numbers
   * @return points
   */
  public int width(GC gc) {
    return Math.max(gc.textExtent(label(low)).x, gc.textExtent(label(high)).x) + THICK + Theme.STEP;
  }

  /**
   * Paints the bar, with its numbers at the left. Display thread.
   *
   * @param gc with the font of the numbers
   * @param theme colours
   * @param right the right edge of the bar
   * @param top its upper edge
   * @param length how tall it is, at least 2
   */
  public void paint(GC gc, Theme theme, int right, int top, int length) {
    int x = right - THICK;
    gc.setAntialias(SWT.OFF);
    for (int i = 0; i < length; i++) {
      int rgb = shades.rgb((length - 1.0 - i) / (length - 1));
      gc.setBackground(new Color(rgb >> 16 & BYTE, rgb >> 8 & BYTE, rgb & BYTE));
      gc.fillRectangle(x, top + i, THICK, 1);
    }
    gc.setAntialias(SWT.ON);
    for (int i = 0; i <= TICKS; i++) {
      String text = label(high + (low - high) * i / TICKS);
      Point size = gc.textExtent(text);
      int y = top + i * (length - 1) / TICKS;
      int inside = Math.clamp((long) y - size.y / 2, top - 2, Math.max(top - 2, top + length - size.y + 2));
      gc.setForeground(theme.color(i == 0 || i == TICKS ? Role.TEXT : Role.DIM));
      gc.drawText(text, x - Theme.STEP - size.x, inside, true);
    }
  }

  /**
   * A number as it stands beside the bar.
   *
   * @param value the number
   * @return with as many decimals as tell the numbers apart, and the unit
   */
  public String label(double value) {
    double span = high - low;
    int decimals = span > 0 ? Math.clamp((long) Math.ceil(DIGITS - Math.log10(span)), 0, MOST_DECIMALS) : 2;
    return Figures.of(value, decimals, unit);
  }
}
