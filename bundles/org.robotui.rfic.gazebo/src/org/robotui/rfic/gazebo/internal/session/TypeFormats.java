package org.robotui.rfic.gazebo.internal.session;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.gazebo.types.GazeboTypes;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.protobuf.NumberedFormat;
import org.robotui.message.payload.protobuf.ProtobufFormat;

/** How messages are read and written, by their types. Safe for all threads. */
public final class TypeFormats {
  private static final int MOST = 10_000;

  private final GazeboTypes types;
  private final Map<String, PayloadFormat> known = new ConcurrentHashMap<>();

  TypeFormats(GazeboTypes types) {
    this.types = types;
  }

  /**
   * The format of a type.
   *
   * @param type its full name
   * @return by the names of its fields, or by their numbers where they are not known here
   */
  public PayloadFormat of(String type) {
    if (known.size() > MOST) {
      known.clear(); // a simulator has some hundred types: somebody makes them up
    }
    return known.computeIfAbsent(type, this::find);
  }

  /**
   * A message, ready to be sent.
   *
   * @param type its full name
   * @param fields by name
   * @return its bytes
   * @throws IllegalArgumentException where it cannot be written
   */
  public byte[] written(String type, Map<String, Object> fields) {
    return bytes(of(type).write(fields));
  }

  /** The bytes of a message. */
  static byte[] bytes(ByteBuffer message) {
    byte[] bytes = new byte[message.remaining()];
    message.get(bytes);
    return bytes;
  }

  private PayloadFormat find(String type) {
    return types.find(type).<PayloadFormat>map(ProtobufFormat::new)
        .orElseGet(() -> new NumberedFormat(type, type + " is not known here, so that its fields have numbers; "
            + "GZ_DESCRIPTOR_PATH can name a folder with its .proto file (looked in: "
            + String.join(", ", types.searched()) + ")"));
  }
}
