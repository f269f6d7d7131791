package org.robotui.uic.diagnostics.internal.model;

/**
 * The worst level in each slot of the time looked back on; immutable.
 */
public final class Strip {
  private final byte[] levels;
  private final long lastSlot;

  Strip(byte[] levels, long lastSlot) {
    this.levels = levels;
    this.lastSlot = lastSlot;
  }

  /** How many slots there are. */
  public int size() {
    return levels.length;
  }

  /** The level in a slot, counted from the oldest. */
  public Level level(int index) {
    return Level.of(levels[index]);
  }

  /** The number of a slot, counted from the oldest; numbers stay while the strip moves on. */
  public long slot(int index) {
    return lastSlot - levels.length + 1 + index;
  }

  /** The place of a slot, or a negative number where it is too old. */
  public int index(long slot) {
    return (int) Math.min(levels.length - 1, slot - (lastSlot - levels.length + 1));
  }
}
