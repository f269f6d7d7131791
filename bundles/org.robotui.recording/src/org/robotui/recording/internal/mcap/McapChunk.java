package org.robotui.recording.internal.mcap;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.internal.codec.ChunkEncoder;
import org.robotui.recording.internal.io.PackedBytes;

/** The chunk that is being filled. */
final class McapChunk {

  private final PackedBytes records = new PackedBytes(1 << 16);
  private final Map<Integer, PackedBytes> indexes = new TreeMap<>();
  private long start = Long.MAX_VALUE;
  private long end = Long.MIN_VALUE;

  boolean isEmpty() {
    return records.size() == 0;
  }

  int size() {
    return records.size();
  }

  void schema(int id, RecordedChannel channel) {
    McapRecords.schema(records, id, channel.schema());
  }

  void channel(RecordedChannel channel, int schema) {
    McapRecords.channel(records, channel, schema);
  }

  void message(int channel, long logTime, long publishTime, long sequence, ByteBuffer data) {
    indexes.computeIfAbsent(channel, id -> new PackedBytes(256)).i64(logTime).i64(records.size());
    records.u8(McapFormat.MESSAGE).i64(McapFormat.MESSAGE_HEAD + (long) data.remaining()).u16(channel).u32(sequence)
        .i64(logTime).i64(publishTime).raw(data);
    start = Math.min(start, logTime);
    end = Math.max(end, logTime);
  }

  /** Puts the chunk and its indexes, and answers its entry for the index of the file. */
  PackedBytes put(PackedBytes out, long offset, ChunkEncoder encoder, String word) {
    Optional<byte[]> smaller = encoder.encode(records.array(), records.size());
    String compression = smaller.isPresent() ? word : "";
    byte[] bytes = smaller.orElse(records.array());
    int length = smaller.isPresent() ? bytes.length : records.size();
    out.u8(McapFormat.CHUNK);
    int record = out.begin(Long.BYTES);
    times(out).i64(records.size()).u32(McapSource.sum(records.array(), 0, records.size())).text(compression)
        .i64(length).raw(bytes, 0, length).end(record, Long.BYTES);
    int chunkEnd = out.size();
    Map<Integer, Long> places = new HashMap<>();
    indexes.forEach((channel, index) -> {
      places.put(channel, offset + out.size());
      out.u8(McapFormat.MESSAGE_INDEX).i64(Short.BYTES + Integer.BYTES + (long) index.size()).u16(channel)
          .u32(index.size()).raw(index.array(), 0, index.size());
    });
    PackedBytes entry = new PackedBytes(128);
    times(entry).i64(offset).i64(chunkEnd);
    int list = entry.begin(Integer.BYTES);
    places.forEach((channel, place) -> entry.u16(channel).i64(place));
    return entry.end(list, Integer.BYTES).i64(out.size() - (long) chunkEnd).text(compression).i64(length)
        .i64(records.size());
  }

  private PackedBytes times(PackedBytes out) {
    return out.i64(start).i64(end);
  }

  /** Puts what is there as it is: without a message there need be no chunk. */
  void putDefinitions(PackedBytes out) {
    out.raw(records.array(), 0, records.size());
    clear();
  }

  void clear() {
    records.clear();
    indexes.clear();
    start = Long.MAX_VALUE;
    end = Long.MIN_VALUE;
  }
}
