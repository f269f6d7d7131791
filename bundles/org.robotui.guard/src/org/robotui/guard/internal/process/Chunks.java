package org.robotui.guard.internal.process;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** The memory of all connections. It never grows beyond its bound. */
final class Chunks {
  static final int SIZE = 64 * 1024;

  private final int most;
  private final Deque<ByteBuffer> free = new ArrayDeque<>();
  private int made;

  Chunks(int most) {
    this.most = most;
  }

  /** An empty chunk, if there is one. */
  Optional<ByteBuffer> take() {
    if (free.isEmpty() && made < most) {
      made++;
      return Optional.of(ByteBuffer.allocateDirect(SIZE));
    }
    return Optional.ofNullable(free.poll());
  }

  boolean areLeft() {
    return made < most || !free.isEmpty();
  }

  void give(ByteBuffer chunk) {
    free.push(chunk.clear());
  }
}
