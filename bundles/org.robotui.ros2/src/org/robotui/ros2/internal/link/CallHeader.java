package org.robotui.ros2.internal.link;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;

/**
 * How Cyclone's programs of ROS 2 say which request a reply is for: by 16 bytes before the first field, in requests as
 * well as in replies. As they are two numbers of eight bytes, what follows keeps its place.
 *
 * @param client who asks
 * @param sequence the client's number of the request
 */
record CallHeader(long client, long sequence) {

  private static final int ENCAPSULATION = 4;
  private static final int BYTES = 2 * Long.BYTES;

  /** A message and the header that was before it. */
  record Opened(CallHeader header, ByteBuffer payload) {}

  private static ByteOrder order(ByteBuffer payload) {
    return (payload.get(payload.position() + 1) & 1) == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
  }

  /** The message with this header before its first field. */
  ByteBuffer before(ByteBuffer payload) {
    ByteBuffer whole = ByteBuffer.allocate(payload.remaining() + BYTES).order(order(payload));
    whole.put(payload.slice(payload.position(), ENCAPSULATION)).putLong(client).putLong(sequence);
    return whole.put(payload.slice(payload.position() + ENCAPSULATION, payload.remaining() - ENCAPSULATION)).flip();
  }

  /** Takes the header off; empty if there is no room for one. */
  static Optional<Opened> open(ByteBuffer payload) {
    if (payload.remaining() < ENCAPSULATION + BYTES) {
      return Optional.empty();
    }
    int start = payload.position();
    ByteBuffer numbers = payload.slice(start + ENCAPSULATION, BYTES).order(order(payload));
    CallHeader header = new CallHeader(numbers.getLong(), numbers.getLong());
    ByteBuffer rest = ByteBuffer.allocate(payload.remaining() - BYTES);
    rest.put(payload.slice(start, ENCAPSULATION));
    rest.put(payload.slice(start + ENCAPSULATION + BYTES, payload.remaining() - ENCAPSULATION - BYTES));
    return Optional.of(new Opened(header, rest.flip()));
  }
}
