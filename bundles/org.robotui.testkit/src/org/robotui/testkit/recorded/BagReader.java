package org.robotui.testkit.recorded;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads bags of ROS 1, format 2.0, in the order of the file: chunks that are plain or compressed by lz4 or bzip2.
 * Trusts the file.
 */
public final class BagReader {
  private static final String MAGIC = "#ROSBAG V2.0\n";
  private static final int MESSAGE = 2;
  private static final int CHUNK = 5;
  private static final int CONNECTION = 7;

  private final Map<Integer, Connection> connections = new HashMap<>();
  private final List<Recorded> messages = new ArrayList<>();

  /** Who sent. */
  private record Connection(String topic, String type, String md5, String definition) {}

  /**
   * One recorded message.
   *
   * @param topic its topic
   * @param type its type as announced
   * @param md5 the sum of the type's definition
   * @param definition the text of the type and all it uses
   * @param nanos when it was recorded
   * @param bytes the message, at position 0
   */
  public record Recorded(String topic, String type, String md5, String definition, long nanos, ByteBuffer bytes) {}

  private BagReader() {}

  /**
   * Reads a file.
   *
   * @param bag the file
   * @return its messages
   */
  public static List<Recorded> read(Path bag) {
    try {
      ByteBuffer in = ByteBuffer.wrap(Files.readAllBytes(bag));
      String magic = text(in, MAGIC.length());
      if (!magic.equals(MAGIC)) {
        throw new IOException(bag + " is no bag of format 2.0");
      }
      BagReader reader = new BagReader();
      reader.records(in);
      return reader.messages;
    } catch (IOException e) {
      throw new UncheckedIOException(bag.toString(), e);
    }
  }

  private void records(ByteBuffer in) throws IOException {
    while (in.hasRemaining()) {
      Map<String, ByteBuffer> header = header(block(in));
      ByteBuffer data = block(in);
      switch (header.get("op").get()) {
        case CHUNK -> records(Unpacking.of(text(header.get("compression"))).unpack(data, header.get("size").getInt()));
        case CONNECTION -> connection(header, data);
        case MESSAGE -> message(header, data);
        default -> {
          // An index: everything is read.
        }
      }
    }
  }

  private void connection(Map<String, ByteBuffer> header, ByteBuffer data) {
    Map<String, ByteBuffer> fields = header(data);
    connections.put(header.get("conn").getInt(), new Connection(
        text(header.get("topic")), text(fields.get("type")), text(fields.get("md5sum")),
        text(fields.get("message_definition"))));
  }

  private void message(Map<String, ByteBuffer> header, ByteBuffer data) {
    Connection from = connections.get(header.get("conn").getInt());
    ByteBuffer time = header.get("time");
    long nanos = Integer.toUnsignedLong(time.getInt()) * 1_000_000_000L + time.getInt();
    messages.add(new Recorded(from.topic(), from.type(), from.md5(), from.definition(), nanos, data));
  }

  private static Map<String, ByteBuffer> header(ByteBuffer in) {
    Map<String, ByteBuffer> fields = new HashMap<>();
    while (in.hasRemaining()) {
      ByteBuffer field = block(in);
      int start = field.position();
      while (field.get() != '=') {
        // up to the equals sign is the name
      }
      ByteBuffer name = field.duplicate().position(start).limit(field.position() - 1);
      fields.put(text(name), field.slice().order(ByteOrder.LITTLE_ENDIAN));
    }
    return fields;
  }

  private static ByteBuffer block(ByteBuffer in) {
    int length = in.order(ByteOrder.LITTLE_ENDIAN).getInt();
    ByteBuffer block = in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN);
    in.position(in.position() + length);
    return block;
  }

  private static String text(ByteBuffer in) {
    return StandardCharsets.UTF_8.decode(in.duplicate()).toString();
  }

  private static String text(ByteBuffer in, int length) {
    byte[] bytes = new byte[length];
    in.get(bytes);
    return new String(bytes, StandardCharsets.UTF_8);
  }
}
