package org.robotui.message.payload.protobuf;

import com.google.protobuf.ByteString;
import com.google.protobuf.UnknownFieldSet;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.RecordShape;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.PayloadFormat;

/**
 * Messages of Protocol Buffers whose type is not known: their fields have numbers for names.
 *
 * @param type the name of the type
 * @param reason why it is not known, and what would help, for users
 */
public record NumberedFormat(String type, String reason) implements PayloadFormat {
  @Override
  public Optional<String> obstacle() {
    return Optional.of(reason);
  }

  @Override
  public Optional<RecordShape> shape() {
    return Optional.empty();
  }

  @Override
  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  public <M> Reading<M> reading(MessageForm<M> form) {
    if (!(form instanceof MessageForm.ByFields)) {
      throw new IllegalArgumentException("messages of Protocol Buffers have no definition of ROS");
    }
    return payload -> (M) new NumberedRecord(type, fields(payload));
  }

  private static UnknownFieldSet fields(ByteBuffer payload) {
    try {
      ProtobufBudget.check(payload);
      return UnknownFieldSet.parseFrom(ByteString.copyFrom(payload.duplicate()));
    } catch (IOException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  @Override
  public ByteBuffer write(Map<String, Object> fields) {
    throw new IllegalArgumentException(reason);
  }
}
