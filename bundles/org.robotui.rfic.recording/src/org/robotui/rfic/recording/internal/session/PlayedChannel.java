package org.robotui.rfic.recording.internal.session;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.recording.RecordedChannel;

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

  /** Who is said to have sent its messages. */
  String sender(String file) {
    return channel.metadata().getOrDefault(SENDER, file);
  }
}
