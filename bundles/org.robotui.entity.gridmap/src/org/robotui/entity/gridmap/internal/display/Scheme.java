package org.robotui.entity.gridmap.internal.display;

import java.nio.ByteBuffer;

/** The colour of each value a cell can have: four bytes red, green, blue, alpha by the value as an unsigned byte. */
final class Scheme {
  private static final int VALUES = 256;
  private static final int FULL = 100;
  private static final int OPAQUE = 0xff;
  /** Seen on a dark and on a light background. */
  private static final int FREE_MAP = 0x808a9650;
  private static final int OCCUPIED_MAP = 0x5d86b8ff;
  private static final int UNKNOWN = 0x70898e40;
  private static final int NO_CELL = 0x46a758ff;
  private static final int INSCRIBED = 0x00ffffff;
  private static final int LETHAL = 0xff00ffff;

  private final int[] rgba = new int[VALUES];

  /**
   * Makes a scheme.
   *
   * @param name map, costmap or raw
   * @param unknown whether unknown cells are painted
   */
  Scheme(String name, boolean unknown) {
    for (int value = 0; value < VALUES; value++) {
      rgba[value] = switch (name) {
        case "costmap" -> cost(value);
        case "raw" -> grey(value);
        default -> map(value);
      };
    }
    if (!name.equals("raw")) {
      rgba[VALUES - 1] = unknown ? UNKNOWN : 0;
    }
  }

  /** Colours cells. */
  ByteBuffer color(byte[] cells) {
    ByteBuffer colors = ByteBuffer.allocateDirect(Integer.BYTES * cells.length);
    for (int i = 0; i < cells.length; i++) {
      colors.putInt(Integer.BYTES * i, rgba[cells[i] & 0xff]);
    }
    return colors;
  }

  private static int map(int value) {
    return value > FULL ? NO_CELL : mix(FREE_MAP, OCCUPIED_MAP, value / (double) FULL);
  }

  /** As rviz colours costs: nothing where they are 0. */
  private static int cost(int value) {
    if (value == 0) {
      return 0;
    }
    if (value == FULL - 1) {
      return INSCRIBED;
    }
    if (value == FULL) {
      return LETHAL;
    }
    return value > FULL ? NO_CELL : mix(0x0000ffff, 0xff0000ff, value / (double) FULL);
  }

  private static int grey(int value) {
    return value * 0x010101 << Byte.SIZE | OPAQUE;
  }

  private static int mix(int from, int to, double share) {
    int mixed = 0;
    for (int shift = 24; shift >= 0; shift -= Byte.SIZE) {
      mixed |= (int) Math.round((from >> shift & 0xff) * (1 - share) + (to >> shift & 0xff) * share) << shift;
    }
    return mixed;
  }
}
