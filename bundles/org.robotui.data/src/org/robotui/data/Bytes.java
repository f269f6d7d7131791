package org.robotui.data;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Objects;

/** An immutable run of bytes, possibly a slice of a received frame, so that large payloads are not copied. */
public final class Bytes {
  /** No bytes. */
  public static final Bytes EMPTY = new Bytes(new byte[0], 0, 0);

  private final byte[] array;
  private final int offset;
  private final int size;

  private Bytes(byte[] array, int offset, int size) {
    this.array = array;
    this.offset = offset;
    this.size = size;
  }

  /**
   * Copies bytes.
   *
   * @param bytes the bytes
   * @return the run
   */
  public static Bytes of(byte... bytes) {
    return wrap(bytes.clone(), 0, bytes.length);
  }

  /**
   * Takes a part of an array over without a copy.
   *
   * @param array the bytes; the caller must not touch that part again
   * @param offset first byte
   * @param size how many
   * @return the run
   */
  public static Bytes wrap(byte[] array, int offset, int size) {
    Objects.checkFromIndexSize(offset, size, array.length);
    return new Bytes(array, offset, size);
  }

  /**
   * Takes what remains of a buffer over, without a copy where the buffer has an array.
   *
   * @param buffer the bytes from position to limit; its content must not change again
   * @return the run
   */
  public static Bytes wrap(ByteBuffer buffer) {
    if (buffer.hasArray()) {
      return wrap(buffer.array(), buffer.arrayOffset() + buffer.position(), buffer.remaining());
    }
    byte[] copy = new byte[buffer.remaining()];
    buffer.duplicate().get(copy);
    return wrap(copy, 0, copy.length);
  }

  /**
   * One byte.
   *
   * @param index from 0
   * @return the byte, signed
   */
  public byte get(int index) {
    Objects.checkIndex(index, size);
    return array[offset + index];
  }

  /**
   * One byte as a number from 0 to 255.
   *
   * @param index from 0
   * @return the byte, unsigned
   */
  public int unsigned(int index) {
    return get(index) & 0xff;
  }

  /**
   * How many.
   *
   * @return the count
   */
  public int size() {
    return size;
  }

  /**
   * A read-only view for bulk access.
   *
   * @param order the byte order of numbers read through it
   * @return a buffer from 0 to {@link #size()}
   */
  public ByteBuffer buffer(ByteOrder order) {
    return ByteBuffer.wrap(array, offset, size).slice().asReadOnlyBuffer().order(order);
  }

  /**
   * Copies into an array.
   *
   * @param from first byte of this run
   * @param target where to
   * @param targetOffset first index there
   * @param count how many
   */
  public void copyTo(int from, byte[] target, int targetOffset, int count) {
    Objects.checkFromIndexSize(from, count, size);
    System.arraycopy(array, offset + from, target, targetOffset, count);
  }

  /**
   * A stream over the bytes, for decoders of compressed formats.
   *
   * @return a stream that needs no closing
   */
  public java.io.InputStream stream() {
    return new java.io.ByteArrayInputStream(array, offset, size);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Bytes bytes && buffer(ByteOrder.BIG_ENDIAN).equals(bytes.buffer(ByteOrder.BIG_ENDIAN));
  }

  @Override
  public int hashCode() {
    return buffer(ByteOrder.BIG_ENDIAN).hashCode();
  }

  @Override
  public String toString() {
    return "Bytes[" + size + "]";
  }
}
