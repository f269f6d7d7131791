package org.robotui.recording.internal.chunk;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.robotui.recording.RecordedChannel;

/** Which channels somebody wants. Immutable. */
final class ChannelFilter {

  private final Map<Integer, RecordedChannel> channels;
  private final int[] wanted;
  private final boolean all;

  /**
   * @param wanted those that there are; empty for all
   */
  ChannelFilter(Map<Integer, RecordedChannel> channels, Set<Integer> wanted) {
    all = wanted.isEmpty();
    this.channels = new HashMap<>(channels);
    if (!all) {
      this.channels.keySet().retainAll(wanted);
    }
    this.wanted = wanted.stream().mapToInt(Integer::intValue).toArray();
  }

  boolean wants(int channel) {
    return channels.containsKey(channel);
  }

  boolean wants(ChunkRef chunk) {
    return all || chunk.hasAny(wanted);
  }

  RecordedChannel channel(int id) {
    return channels.get(id);
  }
}
