package org.robotui.lcm.log;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Where the events of a log are, and when they were. Immutable. */
public final class EventLogIndex {

  /** Names come from a file: those beyond so many are counted as one. */
  private static final int MOST_CHANNELS = 10_000;
  private static final String OTHERS = "";

  private final long[] offsets;
  private final long[] utimes;
  private final Map<String, Integer> channels;
  private final long damagedBytes;

  private EventLogIndex(long[] offsets, long[] utimes, Map<String, Integer> channels, long damagedBytes) {
    this.offsets = offsets;
    this.utimes = utimes;
    this.channels = channels;
    this.damagedBytes = damagedBytes;
  }

  /**
   * Reads through a log; the bytes of its messages are passed over.
   *
   * @param path the file
   * @return its index
   * @throws IOException if it cannot be read
   */
  public static EventLogIndex of(Path path) throws IOException {
    long[] offsets = new long[1024];
    long[] utimes = new long[1024];
    Map<String, Integer> channels = new LinkedHashMap<>();
    int count = 0;
    try (EventLogReader reader = EventLogReader.open(path)) {
      for (Optional<EventLogReader.Span> span = reader.nextSpan(); span.isPresent(); span = reader.nextSpan()) {
        if (count == offsets.length) {
          offsets = Arrays.copyOf(offsets, count * 2);
          utimes = Arrays.copyOf(utimes, count * 2);
        }
        offsets[count] = span.get().start();
        utimes[count++] = reader.utime(span.get());
        String channel = reader.channel(span.get());
        channels.merge(channels.size() < MOST_CHANNELS || channels.containsKey(channel) ? channel : OTHERS, 1,
            Integer::sum);
      }
      return new EventLogIndex(Arrays.copyOf(offsets, count), Arrays.copyOf(utimes, count), channels,
          reader.damagedBytes());
    }
  }

  /**
   * How many events there are.
   *
   * @return the count
   */
  public int size() {
    return offsets.length;
  }

  /**
   * Where an event starts, for {@link EventLogReader#seek}.
   *
   * @param event from 0
   * @return a byte of the file
   */
  public long offset(int event) {
    return offsets[event];
  }

  /**
   * When an event was received.
   *
   * @param event from 0
   * @return microseconds since 1970
   */
  public long utime(int event) {
    return utimes[event];
  }

  /**
   * The first event that is not earlier than a time. The times of a log rise.
   *
   * @param utime microseconds since 1970
   * @return from 0; {@link #size} if all are earlier
   */
  public int at(long utime) {
    int found = Arrays.binarySearch(utimes, utime);
    if (found < 0) {
      return -found - 1;
    }
    while (found > 0 && utimes[found - 1] == utime) {
      found--;
    }
    return found;
  }

  /**
   * Which channels have how many events.
   *
   * @return by name, in the order of their first events
   */
  public Map<String, Integer> channels() {
    return new LinkedHashMap<>(channels);
  }

  /**
   * How much is no event.
   *
   * @return bytes
   */
  public long damagedBytes() {
    return damagedBytes;
  }
}
