package org.robotui.smartsoft.wire;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.net.link.Framing;

/** Frames as bytes. A header of 16 bytes says in which order those of all numbers are, its own as well. */
public final class SmartFraming implements Framing<SmartFrame> {

  /** Bytes of a header. */
  public static final int HEADER = 16;
  /** The most that a pattern may say. */
  public static final int LONGEST_PATTERN = 1 << 16;
  /** The longest communication object that is taken. */
  public static final int LONGEST_OBJECT = 1 << 26;
  /** Where a naming service listens unless it is told otherwise. */
  public static final int NAMING_PORT = 20_002;

  private static final int ORDER_BYTES = 4;

  /**
   * Reads the next frame; blocks until all of it is there.
   *
   * @throws EOFException where the link ends, also within a frame
   * @throws SmartSoftException where the bytes are no frame
   */
  @Override
  public SmartFrame read(InputStream in) throws IOException {
    ByteBuffer header = ByteBuffer.wrap(exactly(in, HEADER));
    ByteOrder order = order(header.get());
    header.order(order).position(ORDER_BYTES); // what lies between is not initialised by senders
    int command = header.getInt();
    int pattern = bounded(header.getInt(), LONGEST_PATTERN, "what the pattern says");
    int object = bounded(header.getInt(), LONGEST_OBJECT, "an object");
    return new SmartFrame(command, order, ByteBuffer.wrap(exactly(in, pattern)), ByteBuffer.wrap(exactly(in, object)));
  }

  @Override
  public byte[] bytes(SmartFrame frame) {
    ByteBuffer pattern = frame.pattern();
    ByteBuffer object = frame.object();
    ByteBuffer out = ByteBuffer.allocate(HEADER + pattern.remaining() + object.remaining()).order(frame.order());
    out.put((byte) (frame.order() == ByteOrder.LITTLE_ENDIAN ? 1 : 0)).position(ORDER_BYTES);
    out.putInt(frame.command()).putInt(pattern.remaining()).putInt(object.remaining());
    return out.put(pattern).put(object).array();
  }

  private static ByteOrder order(byte code) throws SmartSoftException {
    if (code != 0 && code != 1) {
      throw new SmartSoftException(
          "a frame has bytes in the order " + code + "; ACE has 0 (big endian) and 1 (little endian)");
    }
    return code == 1 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
  }

  private static int bounded(int length, int most, String what) throws SmartSoftException {
    if (length < 0 || length > most) {
      throw new SmartSoftException("a frame has " + what + " of " + length + " bytes; at most " + most + " are taken");
    }
    return length;
  }

  /** What is not there yet is not allocated: a stream gives its bytes in pieces. */
  private static byte[] exactly(InputStream in, int length) throws IOException {
    byte[] bytes = in.readNBytes(length);
    if (bytes.length < length) {
      throw new EOFException("the link ended");
    }
    return bytes;
  }
}
