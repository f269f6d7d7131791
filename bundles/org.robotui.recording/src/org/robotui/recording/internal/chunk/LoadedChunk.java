package org.robotui.recording.internal.chunk;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.stream.IntStream;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;

/** The messages of a chunk, in order of their log times. Immutable. */
public final class LoadedChunk {

  private final byte[] bytes;
  private final ByteBuffer view;
  private final EntryTable entries;
  private final int[] order;

  LoadedChunk(byte[] bytes, EntryTable entries) {
    this.bytes = bytes;
    view = ByteBuffer.wrap(bytes).asReadOnlyBuffer();
    this.entries = entries;
    order = entries.byLogTime();
  }

  /** One without messages, where a chunk cannot be read. */
  public static LoadedChunk none() {
    return new EntryTable().over(new byte[0]);
  }

  public int size() {
    return order.length;
  }

  public int channel(int ordinal) {
    return entries.channel(order[ordinal]);
  }

  public long logTime(int ordinal) {
    return entries.logTime(order[ordinal]);
  }

  /** The first that is not earlier than a time; {@link #size} if all are. */
  int firstAt(long time) {
    int low = 0;
    int high = size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (logTime(middle) < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** The newest message of a channel at a time; -1 if there is none. */
  int lastBefore(int channel, long time) {
    int ordinal = (time == Long.MAX_VALUE ? size() : firstAt(time + 1)) - 1;
    while (ordinal >= 0 && channel(ordinal) != channel) {
      ordinal--;
    }
    return ordinal;
  }

  RecordedMessage message(int ordinal, RecordedChannel channel) {
    return new RecordedMessage(channel, logTime(ordinal), publishTime(ordinal), sequence(ordinal), data(ordinal));
  }

  ByteBuffer data(int ordinal) {
    int entry = order[ordinal];
    return view.slice(entries.from(entry), entries.length(entry));
  }

  long publishTime(int ordinal) {
    return entries.publishTime(order[ordinal]);
  }

  long sequence(int ordinal) {
    return entries.sequence(order[ordinal]);
  }

  /** The same messages by other numbers of their channels. */
  LoadedChunk renumbered(Map<Integer, Integer> numbers) {
    return new LoadedChunk(bytes, entries.renumbered(numbers));
  }

  public IntStream channels() {
    return IntStream.range(0, size()).map(this::channel);
  }

  long cost() {
    return bytes.length + size() * (long) EntryTable.COST;
  }
}
