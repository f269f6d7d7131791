package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Reads messages in the serialization of ROS 1: little endian, without padding. */
public final class MessageReader extends BlockReader {

  /**
   * Creates a reader.
   *
   * @param in the message from position to limit; slices of it are handed out, its position is left alone
   */
  public MessageReader(ByteBuffer in) {
    super(in, ByteOrder.LITTLE_ENDIAN);
  }

  @Override
  public long time(String field) throws MessageException {
    ByteBuffer bytes = need(2 * Integer.BYTES, 1, field);
    return Stamps.time(bytes.getInt(), bytes.getInt());
  }

  @Override
  public long duration(String field) throws MessageException {
    ByteBuffer bytes = need(2 * Integer.BYTES, 1, field);
    return Stamps.duration(bytes.getInt(), bytes.getInt());
  }

  @Override
  public String string(String field) throws MessageException {
    return text(count(field, 1));
  }

  /** ROS 1 has no other texts than those of bytes. */
  @Override
  public String wstring(String field) throws MessageException {
    return string(field);
  }

  @Override
  ByteBuffer need(long bytes, int size, String field) throws MessageException {
    if (bytes > in.remaining()) {
      throw new MessageException(bytes + " bytes are needed and " + in.remaining() + " are left", field, offset());
    }
    return in;
  }

  @Override
  int padding() {
    return 0;
  }
}
