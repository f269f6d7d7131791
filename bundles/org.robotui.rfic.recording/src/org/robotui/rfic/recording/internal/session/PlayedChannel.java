package org.robotui.rfic.recording.internal.session;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.robotui.api.port.RawDefinition;
import org.robotui.data.array.Bytes;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;

/**
 * A channel of a recording and how its messages are read.
 *
 * @param channel as it was recorded
 * @param topic its name as robot interfaces have it
 * @param format reads its messages
 * @param count how many messages it has
 */
public record PlayedChannel(RecordedChannel channel, String topic, PayloadFormat format, long count) {
  static final String SENDER = "callerid";

  /** Its definition as a text; descriptors are no text that users read. */
  Optional<String> definition() {
    return Optional.of(new String(channel.schema().definition(), StandardCharsets.UTF_8))
        .filter(text -> !text.isBlank() && !channel.messageEncoding().equals("protobuf"));
  }

  /** Its definition as it was recorded, for who records it again. */
  Optional<RawDefinition> recordedDefinition() {
    RecordedSchema schema = channel.schema();
    return schema.equals(RecordedSchema.NONE) ? Optional.empty()
        : Optional.of(new RawDefinition(schema.name(), schema.encoding(), Bytes.of(schema.definition())));
  }

  /** Who is said to have sent its messages. */
  String sender(String file) {
    return channel.metadata().getOrDefault(SENDER, file);
  }
}
