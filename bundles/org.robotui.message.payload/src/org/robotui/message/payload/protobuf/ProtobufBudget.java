package org.robotui.message.payload.protobuf;

import com.google.protobuf.CodedInputStream;
import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.FieldDescriptor;
import com.google.protobuf.Empty;
import com.google.protobuf.WireFormat;
import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * Counts the values of a message before it is read: an empty message within it is two bytes there, and a hundred here.
 */
final class ProtobufBudget {
  private static final int MOST = 2_000_000;
  private static final int DEEPEST = 100;

  private final CodedInputStream in;
  private int values;

  private ProtobufBudget(ByteBuffer message) {
    this.in = CodedInputStream.newInstance(message.duplicate());
  }

  /**
   * Checks that a message is no larger when it is read than is bearable.
   *
   * @throws IOException if it is, or the bytes are no message
   */
  static void check(Descriptor type, ByteBuffer message) throws IOException {
    new ProtobufBudget(message).message(type, 0);
  }

  /**
   * Checks that the fields of a message whose type is not known are no more than is bearable.
   *
   * @throws IOException if they are, or the bytes are no message
   */
  static void check(ByteBuffer message) throws IOException {
    new ProtobufBudget(message).message(Empty.getDescriptor(), 0);
  }

  private void message(Descriptor type, int depth) throws IOException {
    if (depth > DEEPEST) {
      throw new IOException("messages within messages are more than " + DEEPEST + " deep");
    }
    for (int tag = in.readTag(); tag != 0; tag = in.readTag()) {
      if (++values > MOST) {
        throw new IOException("it has more than " + MOST + " values");
      }
      FieldDescriptor field = type.findFieldByNumber(WireFormat.getTagFieldNumber(tag));
      boolean within = field != null && field.getJavaType() == FieldDescriptor.JavaType.MESSAGE
          && WireFormat.getTagWireType(tag) == WireFormat.WIRETYPE_LENGTH_DELIMITED;
      if (within) {
        int limit = in.pushLimit(in.readRawVarint32());
        message(field.getMessageType(), depth + 1);
        in.popLimit(limit);
      } else {
        in.skipField(tag);
      }
    }
  }
}
