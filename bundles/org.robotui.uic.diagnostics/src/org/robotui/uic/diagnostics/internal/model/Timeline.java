package org.robotui.uic.diagnostics.internal.model;

import java.util.Arrays;

/** The worst level in each slot of time, of the newest slots. One thread. */
final class Timeline {
  private final byte[] ring;
  private long last = Long.MIN_VALUE;

  Timeline(int slots) {
    ring = new byte[slots];
  }

  /** Notes a level; slots that were passed over stay unknown. */
  void mark(long slot, Level level) {
    advance(slot);
    int at = at(slot);
    ring[at] = (byte) Math.max(ring[at], level.ordinal());
  }

  /** What was noted; unknown where it is too old, or in the future. */
  Level level(long slot) {
    return slot > last || slot <= last - ring.length ? Level.UNKNOWN : Level.of(ring[at(slot)]);
  }

  /** The slots up to one. */
  Strip strip(long lastSlot) {
    byte[] levels = new byte[ring.length];
    for (int i = 0; i < levels.length; i++) {
      levels[i] = (byte) level(lastSlot - levels.length + 1 + i).ordinal();
    }
    return new Strip(levels, lastSlot);
  }

  private void advance(long slot) {
    if (last == Long.MIN_VALUE || slot - last >= ring.length) {
      Arrays.fill(ring, (byte) 0);
      last = slot;
    }
    while (last < slot) {
      last++;
      ring[at(last)] = 0;
    }
  }

  private int at(long slot) {
    return Math.floorMod(slot, ring.length);
  }
}
