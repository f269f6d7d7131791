package org.robotui.recording.internal.mcap;

import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.internal.io.PackedBytes;

/** Puts records that stand in chunks and in the summary alike. */
final class McapRecords {

  private McapRecords() {}

  static void schema(PackedBytes out, int id, RecordedSchema schema) {
    int start = begin(out, McapFormat.SCHEMA);
    out.u16(id).text(schema.name()).text(schema.encoding()).block(schema.definition()).end(start, Long.BYTES);
  }

  static void channel(PackedBytes out, RecordedChannel channel, int schema) {
    int start = begin(out, McapFormat.CHANNEL);
    out.u16(channel.id()).u16(schema).text(channel.topic()).text(channel.messageEncoding())
        .texts(channel.metadata()).end(start, Long.BYTES);
  }

  static void record(PackedBytes out, int code, PackedBytes content) {
    out.u8(code).i64(content.size()).raw(content.array(), 0, content.size());
  }

  static int begin(PackedBytes out, int code) {
    return out.u8(code).begin(Long.BYTES);
  }
}
