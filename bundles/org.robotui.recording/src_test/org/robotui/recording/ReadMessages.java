package org.robotui.recording;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** All messages of recordings, in a form that can be compared. */
final class ReadMessages {

  private ReadMessages() {}

  /** A message without what is of its file alone: the number of its channel. */
  record Message(String topic, String encoding, RecordedSchema schema, long logTime, long publishTime, long sequence,
      ByteBuffer data) {}

  static List<Message> of(RecordingReader recording) throws RecordingException {
    return of(recording.cursor(RecordingInterval.ALWAYS, Set.of()));
  }

  static List<Message> of(RecordingCursor cursor) throws RecordingException {
    List<Message> messages = new ArrayList<>();
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      RecordedMessage message = next.get();
      messages.add(new Message(message.channel().topic(), message.channel().messageEncoding(),
          message.channel().schema(), message.logTime(), message.publishTime(), message.sequence(), message.data()));
    }
    return messages;
  }
}
