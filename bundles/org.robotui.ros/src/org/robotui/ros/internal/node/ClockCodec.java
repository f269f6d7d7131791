package org.robotui.ros.internal.node;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;

/** {@code rosgraph_msgs/Clock}, as nanoseconds since the epoch. */
final class ClockCodec implements MessageCodec<Long> {

  private static final long BILLION = 1_000_000_000L;

  @Override
  public MessageInfo info() {
    return new MessageInfo("rosgraph_msgs/Clock", "a9c97c1d230cfc112e270351a944ee47", "time clock\n");
  }

  @Override
  public Long decode(ByteBuffer in) throws MessageException {
    if (in.remaining() != 2 * Integer.BYTES) {
      throw new MessageException("a time has 8 bytes, not " + in.remaining(), "clock", 0);
    }
    ByteBuffer little = in.order(ByteOrder.LITTLE_ENDIAN);
    return Integer.toUnsignedLong(little.getInt()) * BILLION + Integer.toUnsignedLong(little.getInt());
  }

  @Override
  public void encode(Long nanos, MessageWriter out) {
    out.time((int) (nanos / BILLION), (int) (nanos % BILLION));
  }
}
