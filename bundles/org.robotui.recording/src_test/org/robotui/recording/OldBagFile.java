package org.robotui.recording;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/** Writes messages of ROS 1 as a bag of version 1.2, as the recorder of 2009 did, with an index at the end. */
final class OldBagFile {
  private static final String MAGIC = "#ROSRECORD V1.2\n";
  private static final int HEADER_ROOM = 4096;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final Set<String> defined = new HashSet<>();
  private final Map<String, ByteArrayOutputStream> index = new TreeMap<>();
  private final Map<String, String> types = new TreeMap<>();
  private long dataEnd;

  /** All messages of a bag in the order of their times. */
  static byte[] of(RecordingReader recording) throws RecordingException {
    OldBagFile file = new OldBagFile();
    file.out.writeBytes(MAGIC.getBytes(StandardCharsets.US_ASCII));
    file.record(Map.of("op", new byte[]{3}, "index_pos", new byte[Long.BYTES]), new byte[HEADER_ROOM]);
    RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      file.message(next.get());
    }
    byte[] bytes = file.end();
    int place = new String(bytes, 0, 200, StandardCharsets.ISO_8859_1).indexOf("index_pos=") + "index_pos=".length();
    ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putLong(place, file.dataEnd);
    return bytes;
  }

  /** The index names the definition where one comes before the message. */
  private void message(RecordedMessage message) {
    long place = out.size();
    RecordedChannel channel = message.channel();
    byte[] topic = channel.topic().getBytes(StandardCharsets.UTF_8);
    byte[] type = channel.schema().name().getBytes(StandardCharsets.UTF_8);
    byte[] sum = channel.metadata().get("md5sum").getBytes(StandardCharsets.UTF_8);
    if (defined.add(channel.topic())) {
      record(Map.of("op", new byte[]{1}, "topic", topic, "type", type, "md5", sum, "def",
          channel.schema().definition()), new byte[0]);
    }
    byte[] seconds = number((int) (message.logTime() / 1_000_000_000L));
    byte[] rest = number((int) (message.logTime() % 1_000_000_000L));
    ByteArrayOutputStream entries = index.computeIfAbsent(channel.topic(), name -> new ByteArrayOutputStream());
    types.put(channel.topic(), channel.schema().name());
    entries.writeBytes(seconds);
    entries.writeBytes(rest);
    entries.writeBytes(ByteBuffer.allocate(Long.BYTES).order(ByteOrder.LITTLE_ENDIAN).putLong(place).array());
    byte[] data = new byte[message.data().remaining()];
    message.data().duplicate().get(data);
    Map<String, byte[]> header = new TreeMap<>(Map.of("op", new byte[]{2}, "topic", topic, "type", type, "md5", sum,
        "sec", seconds, "nsec", rest));
    for (String name : new String[]{"callerid", "latching"}) {
      Optional.ofNullable(channel.metadata().get(name)).ifPresent(value -> header.put(name, value.getBytes()));
    }
    record(header, data);
  }

  private byte[] end() {
    dataEnd = out.size();
    index.forEach((topic, entries) -> record(Map.of("op", new byte[]{4}, "topic", topic.getBytes(), "type",
        types.get(topic).getBytes(), "ver", number(0), "count", number(entries.size() / 16)), entries.toByteArray()));
    return out.toByteArray();
  }

  private void record(Map<String, byte[]> header, byte[] data) {
    ByteArrayOutputStream fields = new ByteArrayOutputStream();
    new TreeMap<>(header).forEach((name, value) -> {
      fields.writeBytes(number(name.length() + 1 + value.length));
      fields.writeBytes((name + "=").getBytes());
      fields.writeBytes(value);
    });
    out.writeBytes(number(fields.size()));
    out.writeBytes(fields.toByteArray());
    out.writeBytes(number(data.length));
    out.writeBytes(data);
  }

  private static byte[] number(int value) {
    return ByteBuffer.allocate(Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN).putInt(value).array();
  }
}
