package org.robotui.message.payload.protobuf;

import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.DynamicMessage;
import com.google.protobuf.UnsafeByteOperations;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Map;

/** Reads and writes messages by the descriptors of their types. */
public final class ProtobufMessages {
  private ProtobufMessages() {}

  /**
   * Reads a message.
   *
   * @param type its type
   * @param payload the whole message; nobody writes to it again
   * @return its fields
   * @throws IllegalArgumentException where the bytes are no such message
   */
  public static ProtobufRecord read(Descriptor type, ByteBuffer payload) {
    try {
      ProtobufBudget.check(type, payload);
      return new ProtobufRecord(DynamicMessage.parseFrom(type, UnsafeByteOperations.unsafeWrap(payload)));
    } catch (IOException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /**
   * Makes a message.
   *
   * @param type its type
   * @param fields by their names
   * @return the message
   * @throws IllegalArgumentException where it is not filled in like this
   */
  public static ByteBuffer write(Descriptor type, Map<String, Object> fields) {
    return ProtobufBuilder.message(type, fields).toByteString().asReadOnlyByteBuffer();
  }
}
