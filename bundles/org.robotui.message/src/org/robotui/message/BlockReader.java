package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Reads what all encodings have in common: numbers, one after another, and arrays of them as blocks. */
public abstract sealed class BlockReader implements FieldReader permits MessageReader, CdrReader {

  /** The message, positioned at what is read next. */
  final ByteBuffer in;
  private final int start;

  BlockReader(ByteBuffer in, ByteOrder order) {
    this.in = in.asReadOnlyBuffer().order(order);
    this.start = in.position();
  }

  /** Goes to where a value of a size starts, and checks that some bytes follow there. */
  abstract ByteBuffer need(long bytes, int size, String field) throws MessageException;

  /** The bytes after the last field that are no fault. */
  abstract int padding();

  @Override
  public final boolean bool(String field) throws MessageException {
    return need(1, 1, field).get() != 0;
  }

  @Override
  public final int int8(String field) throws MessageException {
    return need(1, 1, field).get();
  }

  @Override
  public final int uint8(String field) throws MessageException {
    return Byte.toUnsignedInt(need(1, 1, field).get());
  }

  @Override
  public final int int16(String field) throws MessageException {
    return need(Short.BYTES, Short.BYTES, field).getShort();
  }

  @Override
  public final int uint16(String field) throws MessageException {
    return Short.toUnsignedInt(need(Short.BYTES, Short.BYTES, field).getShort());
  }

  @Override
  public final int int32(String field) throws MessageException {
    return need(Integer.BYTES, Integer.BYTES, field).getInt();
  }

  @Override
  public final long uint32(String field) throws MessageException {
    return Integer.toUnsignedLong(need(Integer.BYTES, Integer.BYTES, field).getInt());
  }

  @Override
  public final long int64(String field) throws MessageException {
    return need(Long.BYTES, Long.BYTES, field).getLong();
  }

  @Override
  public final long uint64(String field) throws MessageException {
    return int64(field);
  }

  @Override
  public final float float32(String field) throws MessageException {
    return need(Float.BYTES, Float.BYTES, field).getFloat();
  }

  @Override
  public final double float64(String field) throws MessageException {
    return need(Double.BYTES, Double.BYTES, field).getDouble();
  }

  /** A text of so many bytes. */
  final String text(int length) {
    byte[] utf8 = new byte[length];
    in.get(utf8);
    return new String(utf8, StandardCharsets.UTF_8);
  }

  @Override
  public final List<String> strings(String field, int length) throws MessageException {
    return texts(field, length, this::string);
  }

  @Override
  public final List<String> wstrings(String field, int length) throws MessageException {
    return texts(field, length, this::wstring);
  }

  /** Reads one text. */
  private interface TextReader {
    String read(String field) throws MessageException;
  }

  private List<String> texts(String field, int length, TextReader reader) throws MessageException {
    int count = length(field, length, Integer.BYTES);
    List<String> values = new ArrayList<>(length <= SENT ? count : 0);
    for (int i = 0; i < count; i++) {
      values.add(reader.read(field));
    }
    return values;
  }

  @Override
  public final ByteBuffer bytes(String field, int length, int width) throws MessageException {
    return block(field, numbers(field, length, width, 1), 1);
  }

  @Override
  public final int count(String field, long element) throws MessageException {
    ByteBuffer bytes = need(Integer.BYTES, Integer.BYTES, field);
    int offset = offset();
    long count = Integer.toUnsignedLong(bytes.getInt());
    if (count > (element == 0 ? Layout.MAX_EMPTY_ELEMENTS : in.remaining() / element)) {
      throw new MessageException("a length of " + count + " does not fit into the remaining "
          + in.remaining() + " bytes", field, offset);
    }
    return (int) count;
  }

  @Override
  public final int count(String field, int length, long element) throws MessageException {
    return length(field, length, element);
  }

  @Override
  public final short[] shorts(String field, int length, int width) throws MessageException {
    short[] values = new short[numbers(field, length, width, Short.BYTES)];
    block(field, values.length, Short.BYTES).asShortBuffer().get(values);
    return values;
  }

  @Override
  public final int[] ints(String field, int length, int width) throws MessageException {
    int[] values = new int[numbers(field, length, width, Integer.BYTES)];
    block(field, values.length, Integer.BYTES).asIntBuffer().get(values);
    return values;
  }

  @Override
  public final long[] longs(String field, int length, int width) throws MessageException {
    long[] values = new long[numbers(field, length, width, Long.BYTES)];
    block(field, values.length, Long.BYTES).asLongBuffer().get(values);
    return values;
  }

  @Override
  public final float[] floats(String field, int length, int width) throws MessageException {
    float[] values = new float[numbers(field, length, width, Float.BYTES)];
    block(field, values.length, Float.BYTES).asFloatBuffer().get(values);
    return values;
  }

  @Override
  public final double[] doubles(String field, int length, int width) throws MessageException {
    double[] values = new double[numbers(field, length, width, Double.BYTES)];
    block(field, values.length, Double.BYTES).asDoubleBuffer().get(values);
    return values;
  }

  @Override
  public void skip(String field, Primitive type, int count) throws MessageException {
    if (!type.isText()) {
      block(field, count, type.size());
      return;
    }
    for (int i = 0; i < count; i++) {
      if (type == Primitive.STRING) {
        string(field);
      } else {
        wstring(field);
      }
    }
  }

  @Override
  public final void end() throws MessageException {
    if (in.remaining() > padding()) {
      throw new MessageException(in.remaining() + " bytes are left after the last field", "", offset());
    }
  }

  private int numbers(String field, int length, int width, int size) throws MessageException {
    int elements = length(field, length, (long) width * size);
    // a definition may give a length that no message has: checked before anything is made of it
    if (length > SENT) {
      need((long) elements * width * size, elements == 0 ? 1 : size, field);
    }
    return elements * width;
  }

  private int length(String field, int length, long element) throws MessageException {
    if (length > SENT) {
      return length;
    }
    int count = count(field, element);
    int most = LengthBounds.most(length);
    if (count > most) {
      throw new MessageException("a length of " + count + " is more than the " + most + " of the definition", field,
          offset() - Integer.BYTES);
    }
    return count;
  }

  final int offset() {
    return in.position() - start;
  }

  /** Values of one size, which nothing separates. No value needs no place, and so none that fits its size. */
  private ByteBuffer block(String field, int length, int size) throws MessageException {
    int bytes = length * size;
    need((long) length * size, length == 0 ? 1 : size, field);
    ByteBuffer block = in.slice(in.position(), bytes).order(in.order());
    in.position(in.position() + bytes);
    return block;
  }
}
