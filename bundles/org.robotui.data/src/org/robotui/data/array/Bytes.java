package org.robotui.data.array;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Objects;

/** An immutable run of bytes, possibly a slice of a received frame, so that large payloads are not copied. */
public final class Bytes {
  /** No bytes. */
  public static final Bytes EMPTY = new Bytes(ByteBuffer.allocate(0));

  private final ByteBuffer content;

  private Bytes(ByteBuffer content) {
    this.content = content;
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
    return wrap(ByteBuffer.wrap(array, offset, size));
  }

  /**
   * Takes what remains of a buffer over without a copy.
   *
   * @param buffer the bytes from position to limit; its content must not change again
   * @return the run
   */
  public static Bytes wrap(ByteBuffer buffer) {
    return new Bytes(buffer.slice().asReadOnlyBuffer());
  }

  /**
   * One byte.
   *
   * @param index from 0
   * @return the byte, signed
   */
  public byte get(int index) {
    return content.get(index);
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
    return content.limit();
  }

  /**
   * A read-only view for bulk access.
   *
   * @param order the byte order of numbers read through it
   * @return a buffer from 0 to {@link #size()}
   */
  public ByteBuffer buffer(ByteOrder order) {
    return content.duplicate().order(order);
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
    Objects.checkFromIndexSize(from, count, size());
    content.get(from, target, targetOffset, count);
  }

  /**
   * A stream over a copy of the bytes, for decoders of compressed formats.
   *
   * @return a stream that needs no closing
   */
  public InputStream stream() {
    byte[] copy = new byte[size()];
    copyTo(0, copy, 0, copy.length);
    return new ByteArrayInputStream(copy);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Bytes bytes && content.equals(bytes.content);
  }

  @Override
  public int hashCode() {
    return content.hashCode();
  }

  @Override
  public String toString() {
    return "Bytes[" + size() + "]";
  }
}
