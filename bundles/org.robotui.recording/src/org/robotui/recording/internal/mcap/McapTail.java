package org.robotui.recording.internal.mcap;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.PackedBytes;

/** What is written at the end of a file: the summary, its groups and the footer. */
final class McapTail {

  private final Map<Integer, Long> counts = new TreeMap<>();
  private final List<PackedBytes> chunks = new ArrayList<>();
  private final List<PackedBytes> attachments = new ArrayList<>();
  private final List<PackedBytes> metadata = new ArrayList<>();
  private long first = Long.MAX_VALUE;
  private long last = Long.MIN_VALUE;

  void message(int channel, long logTime) {
    counts.merge(channel, 1L, Long::sum);
    first = Math.min(first, logTime);
    last = Math.max(last, logTime);
  }

  void chunk(PackedBytes entry) {
    chunks.add(entry);
  }

  void attachment(PackedBytes entry) {
    attachments.add(entry);
  }

  void metadata(PackedBytes entry) {
    metadata.add(entry);
  }

  long messages() {
    return counts.values().stream().mapToLong(Long::longValue).sum();
  }

  void write(McapFile file, Map<RecordedSchema, Integer> schemas, List<RecordedChannel> channels)
      throws RecordingException {
    file.write(new PackedBytes(16).u8(McapFormat.DATA_END).i64(Integer.BYTES).u32(file.sum()));
    file.restartSum();
    long start = file.position();
    PackedBytes out = new PackedBytes(1 << 16);
    PackedBytes groups = new PackedBytes(256);
    schemas.forEach((schema, id) -> McapRecords.schema(out, id, schema));
    group(groups, McapFormat.SCHEMA, start, 0, out);
    int from = out.size();
    channels.forEach(channel -> McapRecords.channel(out, channel, schemas.getOrDefault(channel.schema(), 0)));
    group(groups, McapFormat.CHANNEL, start, from, out);
    from = out.size();
    McapRecords.record(out, McapFormat.STATISTICS, statistics(schemas.size(), channels.size()));
    group(groups, McapFormat.STATISTICS, start, from, out);
    entries(groups, McapFormat.CHUNK_INDEX, chunks, start, out);
    entries(groups, McapFormat.ATTACHMENT_INDEX, attachments, start, out);
    entries(groups, McapFormat.METADATA_INDEX, metadata, start, out);
    long offsets = start + out.size();
    out.raw(groups.array(), 0, groups.size());
    out.u8(McapFormat.FOOTER).i64(McapFormat.FOOTER_LENGTH - (long) McapFormat.RECORD_HEAD).i64(start).i64(offsets);
    file.write(out);
    byte[] magic = McapFormat.magic();
    file.write(new PackedBytes(16).u32(file.sum()).raw(magic, 0, magic.length));
  }

  private static void entries(PackedBytes groups, int code, List<PackedBytes> entries, long start, PackedBytes out) {
    int from = out.size();
    entries.forEach(entry -> McapRecords.record(out, code, entry));
    group(groups, code, start, from, out);
  }

  private static void group(PackedBytes groups, int code, long start, int from, PackedBytes out) {
    if (out.size() > from) {
      groups.u8(McapFormat.SUMMARY_OFFSET).i64(1 + 2L * Long.BYTES).u8(code).i64(start + from)
          .i64(out.size() - (long) from);
    }
  }

  private PackedBytes statistics(int schemas, int channels) {
    long messages = messages();
    PackedBytes statistics = new PackedBytes(128).i64(messages).u16(schemas).u32(channels).u32(attachments.size())
        .u32(metadata.size()).u32(chunks.size()).i64(messages == 0 ? 0 : first).i64(messages == 0 ? 0 : last);
    int list = statistics.begin(Integer.BYTES);
    counts.forEach((channel, count) -> statistics.u16(channel).i64(count));
    return statistics.end(list, Integer.BYTES);
  }
}
