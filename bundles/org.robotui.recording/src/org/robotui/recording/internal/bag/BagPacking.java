package org.robotui.recording.internal.bag;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.function.Consumer;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.internal.io.PackedBytes;

/** Puts records of bags, and the named fields in them. */
final class BagPacking {
  private static final long SECOND = 1_000_000_000L;

  private BagPacking() {}

  /** A record: fields after their length, data after theirs. */
  static void record(PackedBytes out, int op, Consumer<PackedBytes> fields, Consumer<PackedBytes> data) {
    int header = out.begin(Integer.BYTES);
    field(out, "op", value -> value.u8(op));
    fields.accept(out);
    out.end(header, Integer.BYTES);
    int content = out.begin(Integer.BYTES);
    data.accept(out);
    out.end(content, Integer.BYTES);
  }

  static void field(PackedBytes out, String name, Consumer<PackedBytes> value) {
    int start = out.begin(Integer.BYTES);
    text(out, name + "=");
    value.accept(out);
    out.end(start, Integer.BYTES);
  }

  static void number(PackedBytes out, String name, long value) {
    field(out, name, bytes -> bytes.u32(value));
  }

  static void words(PackedBytes out, String name, String value) {
    field(out, name, bytes -> text(bytes, value));
  }

  static void time(PackedBytes out, long nanos) {
    out.u32(nanos / SECOND).u32(nanos % SECOND);
  }

  /** Who sent what, as bags keep it of each sender of a topic. */
  static void connection(PackedBytes out, int id, RecordedChannel channel, String sum) {
    record(out, BagFields.CONNECTION, fields -> {
      number(fields, "conn", id);
      words(fields, "topic", channel.topic());
    }, data -> {
      words(data, "topic", channel.topic());
      words(data, "type", channel.schema().name());
      words(data, "md5sum", sum);
      field(data, "message_definition", value -> value.raw(channel.schema().definition(), 0,
          channel.schema().definition().length));
      for (Map.Entry<String, String> each : channel.metadata().entrySet()) {
        if (BagConnections.KEPT.contains(each.getKey()) && !each.getKey().equals("md5sum")) {
          words(data, each.getKey(), each.getValue());
        }
      }
    });
  }

  private static void text(PackedBytes out, String words) {
    byte[] bytes = words.getBytes(StandardCharsets.UTF_8);
    out.raw(bytes, 0, bytes.length);
  }
}
