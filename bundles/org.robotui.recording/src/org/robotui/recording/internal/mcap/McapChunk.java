package org.robotui.recording.internal.mcap;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.codec.ChunkEncoder;
import org.robotui.recording.internal.io.PackedBytes;

/** The chunk that is being filled. */
final class McapChunk {

  private final PackedBytes records = PackedBytes.outside(1 << 16);
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

  /** Writes the chunk and its indexes, and answers its entry for the index of the file. */
  PackedBytes write(McapFile file, ChunkEncoder encoder, String word) throws RecordingException {
    SummedBytes plain = SummedBytes.of(records.view());
    Optional<ByteBuffer> smaller = encoder.encode(plain.bytes());
    String compression = smaller.isPresent() ? word : "";
    SummedBytes stored = smaller.map(SummedBytes::of).orElse(plain);
    PackedBytes head = head(plain, compression, stored.bytes().remaining());
    long offset = file.position();
    long chunkEnd = offset + head.size() + stored.bytes().remaining();
    PackedBytes entry = new PackedBytes(128);
    times(entry).i64(offset).i64(chunkEnd - offset);
    PackedBytes index = new PackedBytes(256);
    int list = entry.begin(Integer.BYTES);
    indexes.forEach((channel, times) -> {
      entry.u16(channel).i64(chunkEnd + index.size());
      index.u8(McapFormat.MESSAGE_INDEX).i64(Short.BYTES + Integer.BYTES + (long) times.size()).u16(channel)
          .u32(times.size()).raw(times.view());
    });
    file.write(SummedBytes.of(head.view()), stored, SummedBytes.of(index.view()));
    return entry.end(list, Integer.BYTES).i64(index.size()).text(compression).i64(stored.bytes().remaining())
        .i64(records.size());
  }

  private PackedBytes head(SummedBytes plain, String compression, int stored) {
    PackedBytes fields = times(new PackedBytes(64)).i64(plain.bytes().remaining()).u32(plain.sum()).text(compression)
        .i64(stored);
    return new PackedBytes(128).u8(McapFormat.CHUNK).i64(fields.size() + (long) stored)
        .raw(fields.array(), 0, fields.size());
  }

  private PackedBytes times(PackedBytes out) {
    return out.i64(start).i64(end);
  }

  /** Puts what is there as it is: without a message there need be no chunk. */
  void putDefinitions(PackedBytes out) {
    out.raw(records.view());
    clear();
  }

  void clear() {
    records.clear();
    indexes.clear();
    start = Long.MAX_VALUE;
    end = Long.MIN_VALUE;
  }
}
