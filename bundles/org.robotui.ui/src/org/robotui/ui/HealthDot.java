package org.robotui.ui;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;

/** Draws the dot of a state. Every state has a shape of its own, so that it is known without its colour. */
public final class HealthDot {
  /** The usual diameter, pixels. */
  public static final int SIZE = 9;

  private HealthDot() {}

  /**
   * Draws with the usual size.
   *
   * @param gc where to draw; its colours, line and antialias settings are changed
   * @param theme gives the colour
   * @param health the state
   * @param x centre
   * @param y centre
   */
  public static void paint(GC gc, Theme theme, Health health, int x, int y) {
    paint(gc, theme, health, x, y, SIZE);
  }

  /**
   * Draws.
   *
   * @param gc where to draw; its colours, line and antialias settings are changed
   * @param theme gives the colour
   * @param health the state
   * @param x centre
   * @param y centre
   * @param size diameter, pixels
   */
  public static void paint(GC gc, Theme theme, Health health, int x, int y, int size) {
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.color(health.role()));
    gc.setForeground(theme.color(health.role()));
    gc.setLineStyle(SWT.LINE_SOLID);
    gc.setLineWidth(2);
    int left = x - size / 2;
    int top = y - size / 2;
    switch (health) {
      case OK -> gc.fillOval(left, top, size, size);
      case WARNING -> triangle(gc, left, top, size);
      case BAD -> cross(gc, left, top, size);
      case STALE -> half(gc, left, top, size);
      case WAITING -> gc.drawOval(left + 1, top + 1, size - 3, size - 3);
      case NONE -> gc.drawLine(left + 1, y, left + size - 2, y);
    }
  }

  private static void triangle(GC gc, int left, int top, int size) {
    gc.fillPolygon(new int[]{left - 1, top + size, left + size / 2, top - 1, left + size + 1, top + size});
  }

  private static void cross(GC gc, int left, int top, int size) {
    int end = size - 2;
    gc.setLineWidth(3);
    gc.setLineCap(SWT.CAP_ROUND);
    gc.drawLine(left + 1, top + 1, left + end, top + end);
    gc.drawLine(left + 1, top + end, left + end, top + 1);
  }

  private static void half(GC gc, int left, int top, int size) {
    gc.drawOval(left + 1, top + 1, size - 3, size - 3);
    gc.fillArc(left, top, size, size, 90, 180);
  }
}
