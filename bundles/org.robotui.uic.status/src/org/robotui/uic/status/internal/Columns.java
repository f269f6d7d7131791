package org.robotui.uic.status.internal;

import org.robotui.ui.HealthDot;
import org.robotui.ui.Theme;

/**
 * Where the columns of a line are, pixels from its left. Names come first: what was lost, ages and values give way to
 * them, in this order.
 *
 * @param nameEnd where names end
 * @param age whether there is room for ages
 * @param dropped whether there is room for what was lost
 * @param value how wide the values of ports are; none where there is no room for them
 */
record Columns(int nameEnd, boolean age, boolean dropped, int value) {
  static final int LEAD = Theme.EDGE + HealthDot.SIZE + 2 * Theme.STEP;
  static final int WORD = 84;
  static final int AGE = 52;
  static final int DROPPED = 92;
  static final int GAP = 8;
  private static final double NAME_SHARE = 0.3;
  private static final int ENOUGH_VALUE = 140;
  private static final int LEAST_VALUE = 48;

  /**
   * Divides a line.
   *
   * @param width of the line
   * @param longestName how wide the longest name is
   */
  static Columns of(int width, int longestName) {
    int most = width - WORD - GAP - Theme.EDGE;
    int end = Math.min(Math.max(LEAD + longestName + GAP, (int) (width * NAME_SHARE)), most);
    int room = width - end - WORD - GAP - Theme.EDGE;
    boolean age = room >= AGE + GAP + ENOUGH_VALUE;
    boolean dropped = room >= AGE + DROPPED + 2 * GAP + ENOUGH_VALUE;
    return new Columns(end, age, dropped, room >= LEAST_VALUE ? room : 0);
  }

  /** Where the value begins of what has neither age nor losses. */
  int plainValue() {
    return nameEnd + WORD + GAP;
  }
}
