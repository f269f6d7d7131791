package org.robotui.recording.internal.chunk;

import java.util.Comparator;
import java.util.List;
import java.util.function.IntPredicate;

/** Chunks in order of their first times, and how far those up to each one reach. Immutable. */
final class TimeOrder {

  private final List<ChunkRef> chunks;
  private final long[] reach;

  TimeOrder(List<ChunkRef> unordered) {
    chunks = unordered.stream().filter(chunk -> chunk.messages() != 0)
        .sorted(Comparator.comparingLong(ChunkRef::start).thenComparingLong(ChunkRef::offset)).toList();
    reach = chunks.stream().mapToLong(ChunkRef::end).toArray();
    for (int i = 1; i < reach.length; i++) {
      reach[i] = Math.max(reach[i], reach[i - 1]);
    }
  }

  int size() {
    return chunks.size();
  }

  ChunkRef get(int place) {
    return chunks.get(place);
  }

  /** The last time in this chunk and those before it. */
  long reach(int place) {
    return reach[place];
  }

  /** How many chunks begin at a time or before it. */
  int until(long time) {
    return firstWhere(place -> chunks.get(place).start() > time);
  }

  /** The first chunk that may have something at a time or after it. */
  int from(long time) {
    return firstWhere(place -> reach[place] >= time);
  }

  /** The first place from which on something is so. */
  private int firstWhere(IntPredicate so) {
    int low = 0;
    int high = chunks.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (so.test(middle)) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }
}
