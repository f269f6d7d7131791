package org.robotui.uic.plot.internal.trace;

import java.util.List;

/**
 * The samples that a series held at one moment: immutable, and cheap to take since chunks are only ever added to.
 * Indices run from 0. For all threads.
 */
public final class Samples {
  private final List<Chunk> chunks;
  private final int size;

  Samples(List<Chunk> chunks, int size) {
    this.chunks = List.copyOf(chunks);
    this.size = size;
  }

  public int size() {
    return size;
  }

  /** Nanoseconds. */
  public long time(int index) {
    return chunks.get(index / Chunk.SIZE).time(index % Chunk.SIZE);
  }

  /** NaN breaks the line. */
  public double value(int index) {
    return chunks.get(index / Chunk.SIZE).value(index % Chunk.SIZE);
  }

  /** The first index at or after a time; the size where there is none. */
  public int indexOf(long time) {
    int low = 0;
    int high = size;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (time(middle) < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
}
