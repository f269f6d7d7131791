package org.robotui.recording.internal.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.function.IntFunction;

/** Puts fields one after another, little-endian, into memory that grows. */
public final class PackedBytes {

  private final IntFunction<ByteBuffer> allocate;
  private ByteBuffer bytes;

  /** In an array. */
  public PackedBytes(int room) {
    this(room, ByteBuffer::allocate);
  }

  private PackedBytes(int room, IntFunction<ByteBuffer> allocate) {
    this.allocate = allocate;
    bytes = allocate.apply(room).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Outside of the heap, from where the system takes bytes without a copy; there is no {@link #array} then. */
  public static PackedBytes outside(int room) {
    return new PackedBytes(room, ByteBuffer::allocateDirect);
  }

  public PackedBytes u8(int value) {
    need(1).put((byte) value);
    return this;
  }

  public PackedBytes u16(int value) {
    need(Short.BYTES).putShort((short) value);
    return this;
  }

  public PackedBytes u32(long value) {
    need(Integer.BYTES).putInt((int) value);
    return this;
  }

  public PackedBytes i64(long value) {
    need(Long.BYTES).putLong(value);
    return this;
  }

  public PackedBytes text(String value) {
    return block(value.getBytes(StandardCharsets.UTF_8));
  }

  /** Bytes after their length in 32 bits. */
  public PackedBytes block(byte[] value) {
    return u32(value.length).raw(value, 0, value.length);
  }

  public PackedBytes raw(byte[] value, int from, int length) {
    need(length).put(value, from, length);
    return this;
  }

  public PackedBytes raw(ByteBuffer value) {
    need(value.remaining()).put(value.duplicate());
    return this;
  }

  public PackedBytes texts(Map<String, String> values) {
    int start = begin(Integer.BYTES);
    values.forEach((key, value) -> text(key).text(value));
    return end(start, Integer.BYTES);
  }

  /** Leaves room for a length of 4 or 8 bytes, and says where. */
  public int begin(int width) {
    int start = bytes.position();
    need(width).position(start + width);
    return start;
  }

  /** Puts the length of what came since then. */
  public PackedBytes end(int start, int width) {
    int length = bytes.position() - start - width;
    if (width == Integer.BYTES) {
      bytes.putInt(start, length);
    } else {
      bytes.putLong(start, length);
    }
    return this;
  }

  public int size() {
    return bytes.position();
  }

  /** Valid from 0 to {@link #size}, until more is put. */
  public byte[] array() {
    return bytes.array();
  }

  /** All bytes, until more is put. */
  public ByteBuffer view() {
    return bytes.duplicate().flip();
  }

  public void clear() {
    bytes.clear();
  }

  private ByteBuffer need(int length) {
    if (length > bytes.remaining()) {
      int room =
          (int) Math.min(Integer.MAX_VALUE - 8L, Math.max(2L * bytes.capacity(), bytes.position() + (long) length));
      bytes = allocate.apply(room).order(ByteOrder.LITTLE_ENDIAN).put(bytes.flip());
    }
    return bytes;
  }
}
