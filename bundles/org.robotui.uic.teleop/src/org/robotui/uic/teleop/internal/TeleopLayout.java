package org.robotui.uic.teleop.internal;

import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Theme;

/**
 * Where things lie: the stick left and the figures right, or below each other where it is narrow; what has no room is
 * left out, the least important first.
 *
 * @param stick the square of the stick
 * @param figures rows and bars; empty where there is no room
 * @param rows how many rows of figures: 0, 2 or 4
 * @param bars how many limit bars: 0 or 2
 * @param footer who drives, at the bottom
 */
record TeleopLayout(Rectangle stick, Rectangle figures, int rows, int bars, Rectangle footer) {
  static final int FOOTER = 40;
  static final int ROW = 26;
  static final int BAR = 44;

  private static final int WIDE = 340;
  private static final int LARGEST_STICK = 240;
  private static final int WIDEST_FIGURES = 300;
  private static final int FULL = 4 * ROW + 2 * BAR;
  private static final int SHORT = 2 * ROW + 2 * BAR;
  private static final double STICK_SHARE = 0.48;

  static TeleopLayout of(int width, int height) {
    Rectangle footer = new Rectangle(0, Math.max(0, height - FOOTER), width, FOOTER);
    return width >= WIDE ? beside(width, footer) : below(width, footer);
  }

  private static TeleopLayout beside(int width, Rectangle footer) {
    int half = (int) (width * STICK_SHARE);
    int side = side(half, footer.y);
    Rectangle stick = new Rectangle((half - side) / 2, (footer.y - side) / 2, side, side);
    int left = half + Theme.EDGE / 2;
    int room = Math.min(WIDEST_FIGURES, width - left - Theme.EDGE);
    return with(stick, new Rectangle(left, 0, room, footer.y), footer);
  }

  private static TeleopLayout below(int width, Rectangle footer) {
    int side = side(width, Math.max(footer.y / 2, footer.y - FULL));
    Rectangle stick = new Rectangle((width - side) / 2, Theme.EDGE, side, side);
    int top = side + 2 * Theme.EDGE;
    return with(stick, new Rectangle(Theme.EDGE, top, width - 2 * Theme.EDGE, Math.max(0, footer.y - top)), footer);
  }

  private static TeleopLayout with(Rectangle stick, Rectangle room, Rectangle footer) {
    int rows = room.height >= FULL ? 4 : room.height >= 2 * ROW ? 2 : 0;
    int bars = room.height >= SHORT ? 2 : 0;
    int used = rows * ROW + bars * BAR;
    return new TeleopLayout(stick, new Rectangle(room.x, room.y + (room.height - used) / 2, room.width, used), rows,
        bars, footer);
  }

  private static int side(int width, int height) {
    return Math.max(0,
        Math.min(LARGEST_STICK, (int) ((Math.min(width, height) - 2 * Theme.STEP) / (1 + TeleopPainter.KNOB_SHARE))));
  }

  /** The row of a figure. */
  Rectangle row(int index) {
    return new Rectangle(figures.x, figures.y + index * ROW, figures.width, ROW);
  }

  /** The bar of a limit, its label included. */
  Rectangle bar(int index) {
    return new Rectangle(figures.x, figures.y + rows * ROW + index * BAR, figures.width, BAR);
  }
}
