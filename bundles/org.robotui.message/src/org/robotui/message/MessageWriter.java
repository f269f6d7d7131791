package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * A growing little-endian buffer that codecs write messages into. Not for use by several threads at once.
 */
public final class MessageWriter implements FieldWriter {

  private static final int MAX_CAPACITY = Integer.MAX_VALUE - 8;

  private byte[] array;
  private ByteBuffer buffer;

  /** Creates an empty writer with a small capacity. */
  public MessageWriter() {
    this(256);
  }

  /**
   * Creates an empty writer.
   *
   * @param capacity how many bytes fit before the writer grows for the first time
   */
  public MessageWriter(int capacity) {
    adopt(new byte[Math.max(16, capacity)], 0);
  }

  @Override
  public MessageWriter u8(int value) {
    room(1).put((byte) value);
    return this;
  }

  @Override
  public MessageWriter bool(boolean value) {
    return u8(value ? 1 : 0);
  }

  @Override
  public MessageWriter i16(int value) {
    room(2).putShort((short) value);
    return this;
  }

  @Override
  public MessageWriter i32(int value) {
    room(4).putInt(value);
    return this;
  }

  @Override
  public MessageWriter i64(long value) {
    room(8).putLong(value);
    return this;
  }

  @Override
  public MessageWriter f32(float value) {
    room(4).putFloat(value);
    return this;
  }

  @Override
  public MessageWriter f64(double value) {
    room(8).putDouble(value);
    return this;
  }

  @Override
  public MessageWriter string(String value) {
    byte[] utf8 = value.getBytes(StandardCharsets.UTF_8);
    return array(utf8.length).bytes(utf8, 0, utf8.length);
  }

  /**
   * Appends a ROS time or duration.
   *
   * @param seconds whole seconds
   * @param nanoseconds nanoseconds within the second
   * @return this
   */
  public MessageWriter time(int seconds, int nanoseconds) {
    room(8).putInt(seconds).putInt(nanoseconds);
    return this;
  }

  @Override
  public MessageWriter array(int count) {
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
  public MessageWriter bytes(byte[] source, int offset, int length) {
    room(length).put(source, offset, length);
    return this;
  }

  @Override
  public MessageWriter bytes(ByteBuffer source) {
    room(source.remaining()).put(source.duplicate());
    return this;
  }

  @Override
  public MessageWriter stamp(long nanos) {
    return time(Stamps.secs(nanos), Stamps.nsecs(nanos));
  }

  @Override
  public MessageWriter shorts(short[] values) {
    ByteBuffer out = room((long) values.length * Short.BYTES);
    out.asShortBuffer().put(values);
    out.position(out.position() + values.length * Short.BYTES);
    return this;
  }

  @Override
  public MessageWriter longs(long[] values) {
    ByteBuffer out = room((long) values.length * Long.BYTES);
    out.asLongBuffer().put(values);
    out.position(out.position() + values.length * Long.BYTES);
    return this;
  }

  @Override
  public MessageWriter floats(float[] values) {
    ByteBuffer out = room((long) values.length * Float.BYTES);
    out.asFloatBuffer().put(values);
    out.position(out.position() + values.length * Float.BYTES);
    return this;
  }

  @Override
  public MessageWriter doubles(double[] values) {
    ByteBuffer out = room((long) values.length * Double.BYTES);
    out.asDoubleBuffer().put(values);
    out.position(out.position() + values.length * Double.BYTES);
    return this;
  }

  @Override
  public MessageWriter ints(int[] values) {
    ByteBuffer out = room((long) values.length * Integer.BYTES);
    out.asIntBuffer().put(values);
    out.position(out.position() + values.length * Integer.BYTES);
    return this;
  }

  /**
   * How much was written.
   *
   * @return the number of bytes so far
   */
  public int size() {
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
  public void patchI32(int offset, int value) {
    if (offset + Integer.BYTES > size()) {
      throw new IllegalArgumentException("nothing was written at " + offset);
    }
    buffer.putInt(offset, value);
  }

  /**
   * What was written, without copying it.
   *
   * @return a little-endian view that is valid until the next change of this writer
   */
  public ByteBuffer view() {
    return ByteBuffer.wrap(array, 0, size()).slice().order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * What was written, as a copy.
   *
   * @return a fresh array
   */
  public byte[] toByteArray() {
    return Arrays.copyOf(array, size());
  }

  private ByteBuffer room(long bytes) {
    if (bytes > buffer.remaining()) {
      grow(buffer.position() + bytes);
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
    buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).position(position);
  }
}
