package org.robotui.gl.internal.scene;

import java.util.ArrayDeque;
import java.util.Deque;

/** Pixels of pictures that were handed back, for the next ones. Keeps those of one size, and few. Any thread. */
final class PixelShelf {
  /** One that is copied from while the next picture is drawn, and one in reserve. */
  private static final int MOST = 2;

  private final Deque<int[]> free = new ArrayDeque<>();

  /** As many numbers, of any values. */
  synchronized int[] take(int count) {
    return !free.isEmpty() && free.peek().length == count ? free.pop() : new int[count];
  }

  synchronized void giveBack(int... pixels) {
    free.removeIf(other -> other.length != pixels.length);
    if (free.size() < MOST) {
      free.push(pixels);
    }
  }

  /** Keeps nothing. */
  synchronized void clear() {
    free.clear();
  }
}
