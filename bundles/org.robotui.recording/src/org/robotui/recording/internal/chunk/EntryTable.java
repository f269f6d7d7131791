package org.robotui.recording.internal.chunk;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Map;
import java.util.stream.IntStream;

/** Where the messages of a chunk lie in its bytes, as numbers side by side. */
public final class EntryTable {

  /** Bytes that a message takes here, with its place in the order. */
  static final int COST = 36;

  private int[] channels = new int[64];
  private long[] logTimes = new long[64];
  private long[] publishTimes = new long[64];
  private int[] sequences = new int[64];
  private int[] froms = new int[64];
  private int[] lengths = new int[64];
  private int size;
  private boolean inOrder = true;

  public void add(int channel, long logTime, long publishTime, long sequence, int from, int length) {
    if (size == channels.length) {
      grow();
    }
    inOrder &= size == 0 || logTimes[size - 1] <= logTime;
    channels[size] = channel;
    logTimes[size] = logTime;
    publishTimes[size] = publishTime;
    sequences[size] = (int) sequence;
    froms[size] = from;
    lengths[size++] = length;
  }

  private void grow() {
    int larger = size * 2;
    channels = Arrays.copyOf(channels, larger);
    logTimes = Arrays.copyOf(logTimes, larger);
    publishTimes = Arrays.copyOf(publishTimes, larger);
    sequences = Arrays.copyOf(sequences, larger);
    froms = Arrays.copyOf(froms, larger);
    lengths = Arrays.copyOf(lengths, larger);
  }

  /** The same entries by other numbers of their channels; those of channels without one are left out. */
  EntryTable renumbered(Map<Integer, Integer> numbers) {
    EntryTable other = new EntryTable();
    for (int i = 0; i < size; i++) {
      Integer number = numbers.get(channels[i]);
      if (number != null) {
        other.add(number, logTimes[i], publishTimes[i], sequences[i], froms[i], lengths[i]);
      }
    }
    return other;
  }

  public LoadedChunk over(byte[] bytes) {
    return new LoadedChunk(bytes, this);
  }

  /** Recorders write in this order but for a few. */
  int[] byLogTime() {
    IntStream all = IntStream.range(0, size);
    return inOrder ? all.toArray()
        : all.boxed().sorted(Comparator.comparingLong(this::logTime)).mapToInt(Integer::intValue).toArray();
  }

  int channel(int entry) {
    return channels[entry];
  }

  long logTime(int entry) {
    return logTimes[entry];
  }

  long publishTime(int entry) {
    return publishTimes[entry];
  }

  long sequence(int entry) {
    return sequences[entry] & 0xffff_ffffL;
  }

  int from(int entry) {
    return froms[entry];
  }

  int length(int entry) {
    return lengths[entry];
  }
}
