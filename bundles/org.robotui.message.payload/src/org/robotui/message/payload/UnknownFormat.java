package org.robotui.message.payload;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.RecordShape;
import org.robotui.message.data.MessageForm;

/**
 * Messages that nobody here can read.
 *
 * @param type the name of their type
 * @param reason why
 */
public record UnknownFormat(String type, String reason) implements PayloadFormat {
  @Override
  public Optional<String> obstacle() {
    return Optional.of(reason);
  }

  @Override
  public Optional<RecordShape> shape() {
    return Optional.empty();
  }

  @Override
  public <M> Reading<M> reading(MessageForm<M> form) {
    throw new IllegalArgumentException(reason);
  }

  @Override
  public ByteBuffer write(Map<String, Object> fields) {
    throw new IllegalArgumentException(reason);
  }
}
