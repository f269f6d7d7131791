package org.robotui.message.payload.protobuf;

import com.google.protobuf.Descriptors.Descriptor;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.RecordShape;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.PayloadFormat;

/**
 * Messages of Protocol Buffers.
 *
 * @param descriptor of their type
 */
public record ProtobufFormat(Descriptor descriptor) implements PayloadFormat {
  @Override
  public String type() {
    return descriptor.getFullName();
  }

  @Override
  public Optional<RecordShape> shape() {
    return Optional.of(ProtobufShapes.of(descriptor));
  }

  @Override
  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  public <M> Reading<M> reading(MessageForm<M> form) {
    if (!(form instanceof MessageForm.ByFields)) {
      throw new IllegalArgumentException("messages of Protocol Buffers have no definition of ROS");
    }
    return payload -> (M) ProtobufMessages.read(descriptor, payload);
  }

  @Override
  public ByteBuffer write(Map<String, Object> fields) {
    return ProtobufMessages.write(descriptor, fields);
  }
}
