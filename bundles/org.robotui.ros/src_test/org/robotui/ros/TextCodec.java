package org.robotui.ros;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;

/** std_msgs/String by hand, so that the transport is tested apart from the shipped codecs. */
public final class TextCodec implements MessageCodec<String> {

  @Override
  public MessageInfo info() {
    return new MessageInfo("std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", "string data\n");
  }

  @Override
  public String decode(ByteBuffer in) throws MessageException {
    int length = in.remaining() < 4 ? -1 : in.order(ByteOrder.LITTLE_ENDIAN).getInt();
    if (length != in.remaining()) {
      throw new MessageException("a string of " + length + " bytes where " + in.remaining() + " are", "data", 0);
    }
    byte[] utf8 = new byte[length];
    in.get(utf8);
    return new String(utf8, StandardCharsets.UTF_8);
  }

  @Override
  public void encode(String value, MessageWriter out) {
    out.string(value);
  }
}
