package org.robotui.carmen.wire;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.robotui.carmen.format.IpcFormatException;

/** Frames as bytes. The header is big endian; it says in which order the rest is. */
public final class IpcFraming {

  /** Bytes of a header. */
  public static final int HEADER = 28;
  /** The longest data of a frame that is taken. */
  public static final int LONGEST_BODY = 1 << 26;
  /** Where a central listens unless it is told otherwise. */
  public static final int CENTRAL_PORT = 1381;

  private static final int LONGEST_NAME = 1 << 12;
  private static final int KIND_MASK = 0xffff;
  private static final int ALIGNMENT_MASK = 0xff0000;
  private static final int NAME_ORDER = 28;
  private static final int DATA_ORDER = 24;
  private static final int ORDER_MASK = 0xf;
  private static final int BIG = 1;
  private static final int LITTLE = 2;

  private IpcFraming() {}

  /**
   * Reads the next frame; blocks until all of it is there.
   *
   * @param in of a link between a module and a central, or another module
   * @return the frame
   * @throws EOFException where the link ends, also within a frame
   * @throws IpcFormatException where the bytes are no frame
   * @throws IOException where the link breaks
   */
  public static IpcFrame read(InputStream in) throws IOException {
    ByteBuffer header = ByteBuffer.wrap(exactly(in, HEADER));
    int nameBytes = bounded(header.getInt(), LONGEST_NAME, "name");
    int bodyBytes = bounded(header.getInt(), LONGEST_BODY, "body");
    int parent = header.getInt();
    int intent = header.getInt();
    int kind = header.getInt();
    if ((kind & ALIGNMENT_MASK) != 0) {
      throw new IpcFormatException("a frame is not packed, which no program of today sends");
    }
    ByteOrder names = order(kind >>> NAME_ORDER & ORDER_MASK);
    ByteOrder data = order(kind >>> DATA_ORDER & ORDER_MASK);
    int dispatch = header.getInt();
    int reference = header.getInt();
    String name = name(ByteBuffer.wrap(exactly(in, nameBytes)).order(names));
    return new IpcFrame(parent, intent, kind & KIND_MASK, dispatch, reference, name, data,
        ByteBuffer.wrap(exactly(in, bodyBytes)));
  }

  /**
   * Writes a frame.
   *
   * @param frame to be sent
   * @return all of its bytes
   */
  public static byte[] bytes(IpcFrame frame) {
    byte[] name = frame.name().getBytes(StandardCharsets.ISO_8859_1);
    int nameBytes = name.length == 0 ? 0 : Integer.BYTES + name.length;
    ByteBuffer body = frame.body();
    int order = frame.order() == ByteOrder.LITTLE_ENDIAN ? LITTLE : BIG;
    ByteBuffer out = ByteBuffer.allocate(HEADER + nameBytes + body.remaining());
    out.putInt(nameBytes).putInt(body.remaining()).putInt(frame.parent()).putInt(frame.intent())
        .putInt(order << NAME_ORDER | order << DATA_ORDER | frame.kind()).putInt(frame.dispatch())
        .putInt(frame.reference());
    if (nameBytes > 0) {
      out.order(frame.order()).putInt(name.length).put(name);
    }
    return out.put(body).array();
  }

  private static ByteOrder order(int code) throws IpcFormatException {
    return switch (code) {
      case BIG -> ByteOrder.BIG_ENDIAN;
      case LITTLE -> ByteOrder.LITTLE_ENDIAN;
      default -> throw new IpcFormatException(
          "a frame has bytes in the order " + code + "; IPC has 1 (big endian) and 2 (little endian)");
    };
  }

  private static String name(ByteBuffer in) throws IpcFormatException {
    if (!in.hasRemaining()) {
      return "";
    }
    if (in.remaining() < Integer.BYTES || in.getInt() != in.remaining()) {
      throw new IpcFormatException("a frame has a name that is not as long as it says");
    }
    byte[] characters = new byte[in.remaining()];
    in.get(characters);
    return new String(characters, StandardCharsets.ISO_8859_1);
  }

  private static int bounded(int length, int most, String what) throws IpcFormatException {
    if (length < 0 || length > most) {
      throw new IpcFormatException(
          "a frame has a " + what + " of " + length + " bytes; at most " + most + " are taken");
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
