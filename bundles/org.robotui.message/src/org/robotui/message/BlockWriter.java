package org.robotui.message;

import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/** A growing buffer, and what all encodings write alike: numbers, one after another, and arrays of them as blocks. */
public abstract sealed class BlockWriter implements FieldWriter permits MessageWriter, CdrWriter {

  private static final int MAX_CAPACITY = Integer.MAX_VALUE - 8;
  private static final int MIN_CAPACITY = 16;

  private final ByteOrder order;
  private byte[] array;
  private ByteBuffer buffer;

  BlockWriter(int capacity, ByteOrder order) {
    this.order = order;
    adopt(new byte[Math.max(MIN_CAPACITY, capacity)], 0);
  }

  /** How many bytes lie between the end and the place of a value. */
  abstract int gap(int end, int size);

  @Override
  public abstract BlockWriter string(String value);

  @Override
  public abstract BlockWriter wstring(String value);

  @Override
  public final BlockWriter u8(int value) {
    room(1, 1).put((byte) value);
    return this;
  }

  @Override
  public final BlockWriter bool(boolean value) {
    return u8(value ? 1 : 0);
  }

  @Override
  public final BlockWriter i16(int value) {
    room(Short.BYTES, Short.BYTES).putShort((short) value);
    return this;
  }

  @Override
  public final BlockWriter i32(int value) {
    room(Integer.BYTES, Integer.BYTES).putInt(value);
    return this;
  }

  @Override
  public final BlockWriter i64(long value) {
    room(Long.BYTES, Long.BYTES).putLong(value);
    return this;
  }

  @Override
  public final BlockWriter f32(float value) {
    room(Float.BYTES, Float.BYTES).putFloat(value);
    return this;
  }

  @Override
  public final BlockWriter f64(double value) {
    room(Double.BYTES, Double.BYTES).putDouble(value);
    return this;
  }

  /**
   * Appends a time or duration.
   *
   * @param seconds whole seconds
   * @param nanoseconds nanoseconds within the second
   * @return this
   */
  public final BlockWriter time(int seconds, int nanoseconds) {
    room(2L * Integer.BYTES, Integer.BYTES).putInt(seconds).putInt(nanoseconds);
    return this;
  }

  @Override
  public final BlockWriter stamp(long nanos) {
    return time(Stamps.secs(nanos), Stamps.nsecs(nanos));
  }

  @Override
  public final BlockWriter array(int count) {
    return i32(count);
  }

  /**
   * Appends bytes as they are.
   *
   * @param source holds the bytes
   * @param offset of the first byte
   * @param length how many bytes
   * @return this
   */
  public final BlockWriter bytes(byte[] source, int offset, int length) {
    room(length, 1).put(source, offset, length);
    return this;
  }

  @Override
  public final BlockWriter bytes(ByteBuffer source) {
    room(source.remaining(), 1).put(source.duplicate());
    return this;
  }

  @Override
  public final BlockWriter shorts(short[] values) {
    return block(values.length, Short.BYTES, block -> block.asShortBuffer().put(values));
  }

  @Override
  public final BlockWriter ints(int[] values) {
    return block(values.length, Integer.BYTES, block -> block.asIntBuffer().put(values));
  }

  @Override
  public final BlockWriter longs(long[] values) {
    return block(values.length, Long.BYTES, block -> block.asLongBuffer().put(values));
  }

  @Override
  public final BlockWriter floats(float[] values) {
    return block(values.length, Float.BYTES, block -> block.asFloatBuffer().put(values));
  }

  @Override
  public final BlockWriter doubles(double[] values) {
    return block(values.length, Double.BYTES, block -> block.asDoubleBuffer().put(values));
  }

  /** Fills a block of numbers by way of a view of it. */
  private interface Fill {
    Buffer into(ByteBuffer block);
  }

  /** No number needs no place, and so none that fits its size. */
  private BlockWriter block(int length, int size, Fill fill) {
    if (length > 0) {
      ByteBuffer out = room((long) length * size, size);
      fill.into(out);
      out.position(out.position() + length * size);
    }
    return this;
  }

  @Override
  public final int size() {
    return buffer.position();
  }

  /** Forgets what was written and keeps the capacity. */
  public void clear() {
    buffer.clear();
  }

  /**
   * Replaces 32 bits written earlier, for lengths that are known only afterwards.
   *
   * @param offset where they were written, from the start
   * @param value the new value
   */
  public final void patchI32(int offset, int value) {
    if (offset + Integer.BYTES > size()) {
      throw new IllegalArgumentException("nothing was written at " + offset);
    }
    buffer.putInt(offset, value);
  }

  @Override
  public final ByteBuffer view() {
    return ByteBuffer.wrap(array, 0, size()).slice().order(order);
  }

  /**
   * What was written, as a copy.
   *
   * @return a fresh array
   */
  public final byte[] toByteArray() {
    return Arrays.copyOf(array, size());
  }

  /** Goes to where a value of a size starts. What is between is zero. */
  private ByteBuffer room(long bytes, int size) {
    int gap = gap(buffer.position(), size);
    if (gap + bytes > buffer.remaining()) {
      grow(buffer.position() + gap + bytes);
    }
    for (int i = 0; i < gap; i++) {
      buffer.put((byte) 0);
    }
    return buffer;
  }

  private void grow(long needed) {
    if (needed > MAX_CAPACITY) {
      throw new IllegalArgumentException("a message of " + needed + " bytes is too long");
    }
    int capacity = (int) Math.min(MAX_CAPACITY, Math.max(needed, array.length * 2L));
    adopt(Arrays.copyOf(array, capacity), buffer.position());
  }

  private void adopt(byte[] bytes, int position) {
    array = bytes;
    buffer = ByteBuffer.wrap(bytes).order(order).position(position);
  }
}
