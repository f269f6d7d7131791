package org.robotui.ros2.internal.action;

import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.Optional;
import java.util.UUID;
import org.robotui.message.DynamicMessage;
import org.robotui.message.RosValue;
import org.robotui.ros2.internal.msgs.WireUuid;

/** Identifiers of goals: 16 bytes, or 32 hexadecimal digits. */
final class GoalIds {

  static final int BYTES = 16;

  private GoalIds() {}

  static byte[] random() {
    UUID uuid = UUID.randomUUID();
    return ByteBuffer.allocate(BYTES).putLong(uuid.getMostSignificantBits()).putLong(uuid.getLeastSignificantBits())
        .array();
  }

  static String text(byte[] id) {
    return HexFormat.of().formatHex(id);
  }

  static String text(ByteBuffer id) {
    byte[] bytes = new byte[id.remaining()];
    id.duplicate().get(bytes);
    return text(bytes);
  }

  static WireUuid wire(String text) {
    return new WireUuid(ByteBuffer.wrap(bytes(text)));
  }

  static byte[] bytes(String text) {
    return HexFormat.of().parseHex(text);
  }

  /** The identifier in a field {@code goal_id}, whose message consists of its bytes. */
  static Optional<String> of(DynamicMessage message) {
    return inner(message, "goal_id").map(id -> text(id.bytes()));
  }

  static Optional<DynamicMessage> inner(DynamicMessage message, String field) {
    return message.field(field).orElse(null) instanceof RosValue.Nested nested ? Optional.of(nested.value())
        : Optional.empty();
  }
}
