package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Reads messages in the serialization of ROS 1. */
public final class MessageReader implements FieldReader {

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

  @Override
  public boolean bool(String field) throws MessageException {
    return need(1, field).get() != 0;
  }

  @Override
  public int int8(String field) throws MessageException {
    return need(1, field).get();
  }

  @Override
  public int uint8(String field) throws MessageException {
    return Byte.toUnsignedInt(need(1, field).get());
  }

  @Override
  public int int16(String field) throws MessageException {
    return need(Short.BYTES, field).getShort();
  }

  @Override
  public int uint16(String field) throws MessageException {
    return Short.toUnsignedInt(need(Short.BYTES, field).getShort());
  }

  @Override
  public int int32(String field) throws MessageException {
    return need(Integer.BYTES, field).getInt();
  }

  @Override
  public long uint32(String field) throws MessageException {
    return Integer.toUnsignedLong(need(Integer.BYTES, field).getInt());
  }

  @Override
  public long int64(String field) throws MessageException {
    return need(Long.BYTES, field).getLong();
  }

  @Override
  public long uint64(String field) throws MessageException {
    return int64(field);
  }

  @Override
  public float float32(String field) throws MessageException {
    return need(Float.BYTES, field).getFloat();
  }

  @Override
  public double float64(String field) throws MessageException {
    return need(Double.BYTES, field).getDouble();
  }

  @Override
  public long time(String field) throws MessageException {
    ByteBuffer bytes = need(2 * Integer.BYTES, field);
    return Stamps.time(bytes.getInt(), bytes.getInt());
  }

  @Override
  public long duration(String field) throws MessageException {
    ByteBuffer bytes = need(2 * Integer.BYTES, field);
    return Stamps.duration(bytes.getInt(), bytes.getInt());
  }

  @Override
  public String string(String field) throws MessageException {
    byte[] utf8 = new byte[count(field, 1)];
    in.get(utf8);
    return new String(utf8, StandardCharsets.UTF_8);
  }

  @Override
  public List<String> strings(String field, int length) throws MessageException {
    int count = length == SENT ? count(field, Integer.BYTES) : length;
    List<String> values = new ArrayList<>(length == SENT ? count : 0);
    for (int i = 0; i < count; i++) {
      values.add(string(field));
    }
    return values;
  }

  @Override
  public ByteBuffer bytes(String field, int length, int width) throws MessageException {
    int count = numbers(field, length, width, 1);
    ByteBuffer slice = need(count, field).slice(in.position(), count);
    in.position(in.position() + count);
    return slice;
  }

  @Override
  public int count(String field, long element) throws MessageException {
    int offset = offset();
    long count = Integer.toUnsignedLong(need(Integer.BYTES, field).getInt());
    if (count > (element == 0 ? Layout.MAX_EMPTY_ELEMENTS : in.remaining() / element)) {
      throw new MessageException("a length of " + count + " does not fit into the remaining "
          + in.remaining() + " bytes", field, offset);
    }
    return (int) count;
  }

  @Override
  public short[] shorts(String field, int length, int width) throws MessageException {
    int count = numbers(field, length, width, Short.BYTES);
    ByteBuffer bytes = block(field, count, Short.BYTES);
    short[] values = new short[count];
    bytes.asShortBuffer().get(values);
    return values;
  }

  @Override
  public int[] ints(String field, int length, int width) throws MessageException {
    int count = numbers(field, length, width, Integer.BYTES);
    ByteBuffer bytes = block(field, count, Integer.BYTES);
    int[] values = new int[count];
    bytes.asIntBuffer().get(values);
    return values;
  }

  @Override
  public long[] longs(String field, int length, int width) throws MessageException {
    int count = numbers(field, length, width, Long.BYTES);
    ByteBuffer bytes = block(field, count, Long.BYTES);
    long[] values = new long[count];
    bytes.asLongBuffer().get(values);
    return values;
  }

  @Override
  public float[] floats(String field, int length, int width) throws MessageException {
    int count = numbers(field, length, width, Float.BYTES);
    ByteBuffer bytes = block(field, count, Float.BYTES);
    float[] values = new float[count];
    bytes.asFloatBuffer().get(values);
    return values;
  }

  @Override
  public double[] doubles(String field, int length, int width) throws MessageException {
    int count = numbers(field, length, width, Double.BYTES);
    ByteBuffer bytes = block(field, count, Double.BYTES);
    double[] values = new double[count];
    bytes.asDoubleBuffer().get(values);
    return values;
  }

  @Override
  public void skip(String field, Primitive type, int count) throws MessageException {
    if (type == Primitive.STRING) {
      for (int i = 0; i < count; i++) {
        bytes(field, SENT, 1);
      }
    } else {
      block(field, count, type.size());
    }
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

  private int numbers(String field, int length, int width, int size) throws MessageException {
    return (length == SENT ? count(field, (long) width * size) : length) * width;
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
