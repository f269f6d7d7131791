package org.robotui.recording.internal.chunk;

import java.nio.ByteBuffer;
import java.util.stream.IntStream;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;

/** The messages of a chunk, in order of their log times. Immutable. */
public final class LoadedChunk {

  private final byte[] bytes;
  private final EntryTable entries;
  private final int[] order;

  LoadedChunk(byte[] bytes, EntryTable entries) {
    this.bytes = bytes;
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
    int entry = order[ordinal];
    ByteBuffer data = ByteBuffer.wrap(bytes, entries.from(entry), entries.length(entry)).slice().asReadOnlyBuffer();
    return new RecordedMessage(channel, entries.logTime(entry), entries.publishTime(entry), entries.sequence(entry),
        data);
  }

  public IntStream channels() {
    return IntStream.range(0, size()).map(this::channel);
  }

  long cost() {
    return bytes.length + size() * (long) EntryTable.COST;
  }
}
