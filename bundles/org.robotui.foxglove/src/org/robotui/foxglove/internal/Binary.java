package org.robotui.foxglove.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.robotui.web.tree.TreeException;

/** The binary messages of a server, read within what is there, and those of a client. All is little endian. */
public sealed interface Binary {

  /** A message of a subscription. */
  record Data(long subscription, long nanos, ByteBuffer payload, long receivedNanos) implements Binary {}

  /** The server's time. */
  record Time(long nanos) implements Binary {}

  /** The answer to a call. */
  record Reply(long service, long call, String encoding, ByteBuffer payload) implements Binary {}

  /** Something that is of no use here. */
  record Other() implements Binary {}

  /** Reads a message; what is of a kind that is not known is {@link Other}. */
  static Binary read(ByteBuffer message) throws TreeException {
    ByteBuffer in = message.slice().order(ByteOrder.LITTLE_ENDIAN);
    return switch (need(in, 1).get()) {
      case 1 -> {
        need(in, 12);
        yield new Data(unsigned(in), in.getLong(), in.slice(), System.nanoTime());
      }
      case 2 -> new Time(need(in, 8).getLong());
      case 3 -> {
        need(in, 12);
        yield new Reply(unsigned(in), unsigned(in), text(in), in.slice());
      }
      default -> new Other();
    };
  }

  /** A message on a channel of a client. */
  static ByteBuffer publish(int channel, ByteBuffer payload) {
    ByteBuffer out = ByteBuffer.allocate(5 + payload.remaining()).order(ByteOrder.LITTLE_ENDIAN);
    return out.put((byte) 1).putInt(channel).put(payload.duplicate()).flip();
  }

  /** A call. */
  static ByteBuffer call(long service, int call, String encoding, ByteBuffer payload) {
    byte[] name = encoding.getBytes(StandardCharsets.UTF_8);
    ByteBuffer out = ByteBuffer.allocate(13 + name.length + payload.remaining()).order(ByteOrder.LITTLE_ENDIAN);
    return out.put((byte) 2).putInt((int) service).putInt(call).putInt(name.length).put(name).put(payload.duplicate())
        .flip();
  }

  private static ByteBuffer need(ByteBuffer in, long bytes) throws TreeException {
    if (bytes > in.remaining()) {
      throw new TreeException("a binary message ends after " + in.limit() + " bytes, where " + bytes
          + " more are needed");
    }
    return in;
  }

  private static long unsigned(ByteBuffer in) {
    return Integer.toUnsignedLong(in.getInt());
  }

  private static String text(ByteBuffer in) throws TreeException {
    long length = unsigned(in);
    need(in, length);
    byte[] bytes = new byte[(int) length];
    in.get(bytes);
    return new String(bytes, StandardCharsets.UTF_8);
  }
}
