package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Reads messages in CDR, version 1, of either byte order, where each number starts at a multiple of its size. In the
 * encoding of ROS 2, four bytes of encapsulation before them tell the order; elsewhere something else does.
 */
public final class CdrReader extends BlockReader {

  /** The bytes before the first field. */
  static final int HEADER = 4;

  /** Transports fill the last word of a message up. */
  private static final int PADDING = 3;

  private final int origin;
  private final int padding;

  /**
   * Creates a reader.
   *
   * @param in the message from position to limit, with its encapsulation; slices of it are handed out, its position is
   * left alone
   * @throws MessageException if the encapsulation is missing, or says another encoding
   */
  public CdrReader(ByteBuffer in) throws MessageException {
    super(in, order(in));
    this.in.position(in.position() + HEADER);
    this.origin = this.in.position();
    this.padding = PADDING;
  }

  /**
   * Creates a reader of bytes without encapsulation, as ACE sends them.
   *
   * @param in the message from position to limit, nothing before or behind it; slices of it are handed out, its
   * position is left alone
   * @param order of the bytes of a number
   */
  public CdrReader(ByteBuffer in, ByteOrder order) {
    super(in, order);
    this.origin = this.in.position();
    this.padding = 0;
  }

  private static ByteOrder order(ByteBuffer in) throws MessageException {
    if (in.remaining() < HEADER) {
      throw new MessageException("4 bytes of encapsulation are needed and " + in.remaining() + " are left", "", 0);
    }
    int kind = Byte.toUnsignedInt(in.get(in.position())) << 8 | Byte.toUnsignedInt(in.get(in.position() + 1));
    return switch (kind) {
      case 0 -> ByteOrder.BIG_ENDIAN;
      case 1 -> ByteOrder.LITTLE_ENDIAN;
      default -> throw new MessageException(
          String.format("the encapsulation 0x%04x is not that of CDR, version 1", kind), "", 0);
    };
  }

  @Override
  public long time(String field) throws MessageException {
    ByteBuffer bytes = need(2 * Integer.BYTES, Integer.BYTES, field);
    return Stamps.signed(bytes.getInt(), bytes.getInt());
  }

  @Override
  public long duration(String field) throws MessageException {
    return time(field);
  }

  /** A text ends with a zero, which its length counts; one without is taken as it is, as other readers do. */
  @Override
  public String string(String field) throws MessageException {
    int length = count(field, 1);
    boolean terminated = length > 0 && in.get(in.position() + length - 1) == 0;
    String text = text(terminated ? length - 1 : length);
    in.position(in.position() + (terminated ? 1 : 0));
    return text;
  }

  /** The number of characters, then each in two bytes, as Fast CDR 2 sends it. */
  @Override
  public String wstring(String field) throws MessageException {
    int length = count(field, 1);
    if (length % Character.BYTES != 0) {
      throw new MessageException("a text of wide characters has " + length + " bytes", field, offset() - Integer.BYTES);
    }
    char[] text = new char[length / Character.BYTES];
    for (int i = 0; i < text.length; i++) {
      text[i] = in.getChar();
    }
    return new String(text);
  }

  @Override
  public void skip(String field, Primitive type, int count) throws MessageException {
    if (type.isTemporal()) {
      super.skip(field, Primitive.INT32, Math.multiplyExact(2, count));
    } else {
      super.skip(field, type, count);
    }
  }

  @Override
  ByteBuffer need(long bytes, int size, String field) throws MessageException {
    int gap = -(in.position() - origin) & size - 1;
    if (gap + bytes > in.remaining()) {
      throw new MessageException(bytes + " bytes are needed and " + Math.max(0, in.remaining() - gap) + " are left",
          field, offset());
    }
    if (gap > 0) {
      in.position(in.position() + gap);
    }
    return in;
  }

  @Override
  int padding() {
    return padding;
  }
}
