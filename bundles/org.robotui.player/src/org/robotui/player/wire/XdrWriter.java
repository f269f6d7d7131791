package org.robotui.player.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Writes XDR as Player does: big endian, everything padded to four bytes, lengths before arrays. For one thread. */
public final class XdrWriter {

  private static final int FIRST = 64;

  private ByteBuffer out = ByteBuffer.allocate(FIRST).order(ByteOrder.BIG_ENDIAN);

  /**
   * A whole number of four bytes, signed or not.
   *
   * @param value of which the lower four bytes are written
   * @return this
   */
  public XdrWriter i32(long value) {
    room(Integer.BYTES).putInt((int) value);
    return this;
  }

  /**
   * A whole number of eight bytes.
   *
   * @param value the number
   * @return this
   */
  public XdrWriter i64(long value) {
    room(Long.BYTES).putLong(value);
    return this;
  }

  /**
   * A real number of four bytes.
   *
   * @param value the number
   * @return this
   */
  public XdrWriter f32(float value) {
    room(Float.BYTES).putInt(Float.floatToRawIntBits(value));
    return this;
  }

  /**
   * A real number of eight bytes.
   *
   * @param value the number
   * @return this
   */
  public XdrWriter f64(double value) {
    room(Double.BYTES).putLong(Double.doubleToRawLongBits(value));
    return this;
  }

  /**
   * Bytes, padded with zeros.
   *
   * @param bytes without a length
   * @return this
   */
  public XdrWriter bytes(byte[] bytes) {
    int padding = XdrReader.padding(bytes.length);
    room(bytes.length + padding).put(bytes);
    for (int i = 0; i < padding; i++) {
      out.put((byte) 0);
    }
    return this;
  }

  /**
   * What was written so far.
   *
   * @return a read-only view; nothing may be written after this
   */
  public ByteBuffer buffer() {
    return out.duplicate().flip().slice().asReadOnlyBuffer();
  }

  private ByteBuffer room(int bytes) {
    if (out.remaining() < bytes) {
      int wanted = Math.max(out.capacity() * 2, out.position() + bytes);
      out = ByteBuffer.allocate(wanted).order(ByteOrder.BIG_ENDIAN).put(out.flip());
    }
    return out;
  }
}
