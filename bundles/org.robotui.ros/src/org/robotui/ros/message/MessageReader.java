package org.robotui.ros.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads the fields of one message in order. Every read is checked against the remaining bytes before anything is
 * allocated; an error names the field. Not for use by several threads at once.
 */
public final class MessageReader {

  private final ByteBuffer in;
  private final int start;

  /**
   * Creates a reader.
   *
   * @param in the message from position to limit; slices of it are handed out, its position is left alone
   */
  public MessageReader(ByteBuffer in) {
    this.in = in.asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN);
    this.start = in.position();
  }

  /**
   * Reads a ROS bool.
   *
   * @param field for errors
   * @return true unless the byte is 0
   * @throws MessageException if the message ends here
   */
  public boolean bool(String field) throws MessageException {
    return need(1, field).get() != 0;
  }

  /**
   * Reads a signed byte.
   *
   * @param field for errors
   * @return -128 to 127
   * @throws MessageException if the message ends here
   */
  public int int8(String field) throws MessageException {
    return need(1, field).get();
  }

  /**
   * Reads an unsigned byte.
   *
   * @param field for errors
   * @return 0 to 255
   * @throws MessageException if the message ends here
   */
  public int uint8(String field) throws MessageException {
    return Byte.toUnsignedInt(need(1, field).get());
  }

  /**
   * Reads a signed 16-bit integer.
   *
   * @param field for errors
   * @return the number
   * @throws MessageException if the message ends here
   */
  public int int16(String field) throws MessageException {
    return need(Short.BYTES, field).getShort();
  }

  /**
   * Reads an unsigned 16-bit integer.
   *
   * @param field for errors
   * @return 0 to 65535
   * @throws MessageException if the message ends here
   */
  public int uint16(String field) throws MessageException {
    return Short.toUnsignedInt(need(Short.BYTES, field).getShort());
  }

  /**
   * Reads a signed 32-bit integer.
   *
   * @param field for errors
   * @return the number
   * @throws MessageException if the message ends here
   */
  public int int32(String field) throws MessageException {
    return need(Integer.BYTES, field).getInt();
  }

  /**
   * Reads an unsigned 32-bit integer.
   *
   * @param field for errors
   * @return 0 to 4294967295
   * @throws MessageException if the message ends here
   */
  public long uint32(String field) throws MessageException {
    return Integer.toUnsignedLong(need(Integer.BYTES, field).getInt());
  }

  /**
   * Reads a 64-bit integer.
   *
   * @param field for errors
   * @return the number; for {@code uint64} its bits
   * @throws MessageException if the message ends here
   */
  public long int64(String field) throws MessageException {
    return need(Long.BYTES, field).getLong();
  }

  /**
   * Reads a 32-bit float.
   *
   * @param field for errors
   * @return the number
   * @throws MessageException if the message ends here
   */
  public float float32(String field) throws MessageException {
    return need(Float.BYTES, field).getFloat();
  }

  /**
   * Reads a 64-bit float.
   *
   * @param field for errors
   * @return the number
   * @throws MessageException if the message ends here
   */
  public double float64(String field) throws MessageException {
    return need(Double.BYTES, field).getDouble();
  }

  /**
   * Reads a time.
   *
   * @param field for errors
   * @return nanoseconds
   * @throws MessageException if the message ends here
   */
  public long time(String field) throws MessageException {
    ByteBuffer bytes = need(2 * Integer.BYTES, field);
    return Stamps.time(bytes.getInt(), bytes.getInt());
  }

  /**
   * Reads a duration.
   *
   * @param field for errors
   * @return nanoseconds
   * @throws MessageException if the message ends here
   */
  public long duration(String field) throws MessageException {
    ByteBuffer bytes = need(2 * Integer.BYTES, field);
    return Stamps.duration(bytes.getInt(), bytes.getInt());
  }

  /**
   * Reads a text.
   *
   * @param field for errors
   * @return the text; bytes that are no UTF-8 become replacement characters
   * @throws MessageException if the length exceeds the message
   */
  public String string(String field) throws MessageException {
    byte[] utf8 = new byte[count(field, 1)];
    in.get(utf8);
    return new String(utf8, StandardCharsets.UTF_8);
  }

  /**
   * Reads an array of bytes of variable length without copying it.
   *
   * @param field for errors
   * @return a read-only slice of the message
   * @throws MessageException if the length exceeds the message
   */
  public ByteBuffer bytes(String field) throws MessageException {
    return bytes(field, count(field, 1));
  }

  /**
   * Reads an array of bytes of known length without copying it.
   *
   * @param field  for errors
   * @param length how many bytes
   * @return a read-only slice of the message
   * @throws MessageException if the length exceeds the message
   */
  public ByteBuffer bytes(String field, int length) throws MessageException {
    ByteBuffer slice = need(length, field).slice(in.position(), length);
    in.position(in.position() + length);
    return slice;
  }

  /**
   * Reads the length of an array of variable length.
   *
   * @param field   for errors
   * @param element the fewest bytes of one element, at least 1
   * @return the number of elements, which the remaining bytes can hold
   * @throws MessageException if they cannot
   */
  public int count(String field, long element) throws MessageException {
    int offset = offset();
    long count = Integer.toUnsignedLong(need(Integer.BYTES, field).getInt());
    if (count > in.remaining() / element) {
      throw new MessageException("a length of " + count + " does not fit into the remaining "
          + in.remaining() + " bytes", field, offset);
    }
    return (int) count;
  }

  /**
   * Reads 16-bit integers in one go.
   *
   * @param field  for errors
   * @param length how many; see {@link #count}
   * @return the numbers
   * @throws MessageException if the length exceeds the message
   */
  public short[] shorts(String field, int length) throws MessageException {
    ByteBuffer bytes = block(field, length, Short.BYTES);
    short[] values = new short[length];
    bytes.asShortBuffer().get(values);
    return values;
  }

  /**
   * Reads 32-bit integers in one go.
   *
   * @param field  for errors
   * @param length how many; see {@link #count}
   * @return the numbers; for {@code uint32} their bits
   * @throws MessageException if the length exceeds the message
   */
  public int[] ints(String field, int length) throws MessageException {
    ByteBuffer bytes = block(field, length, Integer.BYTES);
    int[] values = new int[length];
    bytes.asIntBuffer().get(values);
    return values;
  }

  /**
   * Reads 64-bit integers in one go.
   *
   * @param field  for errors
   * @param length how many; see {@link #count}
   * @return the numbers; for {@code uint64} their bits
   * @throws MessageException if the length exceeds the message
   */
  public long[] longs(String field, int length) throws MessageException {
    ByteBuffer bytes = block(field, length, Long.BYTES);
    long[] values = new long[length];
    bytes.asLongBuffer().get(values);
    return values;
  }

  /**
   * Reads 32-bit floats in one go.
   *
   * @param field  for errors
   * @param length how many; see {@link #count}
   * @return the numbers
   * @throws MessageException if the length exceeds the message
   */
  public float[] floats(String field, int length) throws MessageException {
    ByteBuffer bytes = block(field, length, Float.BYTES);
    float[] values = new float[length];
    bytes.asFloatBuffer().get(values);
    return values;
  }

  /**
   * Reads 64-bit floats in one go.
   *
   * @param field  for errors
   * @param length how many; see {@link #count}
   * @return the numbers
   * @throws MessageException if the length exceeds the message
   */
  public double[] doubles(String field, int length) throws MessageException {
    ByteBuffer bytes = block(field, length, Double.BYTES);
    double[] values = new double[length];
    bytes.asDoubleBuffer().get(values);
    return values;
  }

  /**
   * Reads texts.
   *
   * @param field for errors
   * @return the texts
   * @throws MessageException if a length exceeds the message
   */
  public List<String> strings(String field) throws MessageException {
    int count = count(field, Integer.BYTES);
    List<String> values = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      values.add(string(field));
    }
    return values;
  }

  /**
   * Reads a nested message.
   *
   * @param field for errors
   * @param codec of its type
   * @param <T>   its Java value
   * @return the message
   * @throws MessageException if it is broken; the path starts with {@code field}
   */
  public <T> T nested(String field, RecordCodec<T> codec) throws MessageException {
    try {
      return codec.read(this);
    } catch (MessageException e) {
      throw e.within(field);
    }
  }

  /**
   * Reads an array of nested messages of variable length.
   *
   * @param field for errors
   * @param codec of their type
   * @param <T>   their Java value
   * @return the messages
   * @throws MessageException if one is broken; the path starts with {@code field[index]}
   */
  public <T> List<T> list(String field, RecordCodec<T> codec) throws MessageException {
    int count = count(field, Math.max(1, codec.minSize()));
    List<T> values = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      try {
        values.add(codec.read(this));
      } catch (MessageException e) {
        throw e.within("[" + i + "]").within(field);
      }
    }
    return values;
  }

  /**
   * Checks that the whole message was read.
   *
   * @throws MessageException if bytes are left
   */
  public void end() throws MessageException {
    if (in.hasRemaining()) {
      throw new MessageException(in.remaining() + " bytes are left after the last field", "", offset());
    }
  }

  private int offset() {
    return in.position() - start;
  }

  private ByteBuffer block(String field, int length, int element) throws MessageException {
    ByteBuffer bytes = need((long) length * element, field).slice(in.position(), length * element);
    in.position(in.position() + length * element);
    return bytes.order(ByteOrder.LITTLE_ENDIAN);
  }

  private ByteBuffer need(long bytes, String field) throws MessageException {
    if (bytes > in.remaining()) {
      throw new MessageException(
          bytes + " bytes are needed and " + in.remaining() + " are left", field, offset());
    }
    return in;
  }
}
