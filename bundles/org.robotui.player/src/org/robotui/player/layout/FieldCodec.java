package org.robotui.player.layout;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.List;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.XdrReader;
import org.robotui.player.wire.XdrWriter;

/** Between one field's bytes and its Java value: one element, or an array of them. */
final class FieldCodec {

  /** One element. */
  private interface Element {

    Object read(XdrReader in) throws PlayerException;

    void write(Object value, XdrWriter out);

    int minBytes();

    Object readMany(int count, XdrReader in) throws PlayerException;
  }

  private record Builtin(Primitive primitive) implements Element {

    @Override
    public Object read(XdrReader in) throws PlayerException {
      return primitive.read(in);
    }

    @Override
    public void write(Object value, XdrWriter out) {
      primitive.write(value, out);
    }

    @Override
    public int minBytes() {
      return primitive.minBytes();
    }

    @Override
    public Object readMany(int count, XdrReader in) throws PlayerException {
      return switch (primitive) {
        case I32 -> in.i32s(count);
        case F32 -> in.f32s(count);
        case F64 -> in.f64s(count);
        default -> readOneByOne(count, in);
      };
    }

    private Object readOneByOne(int count, XdrReader in) throws PlayerException {
      Object array = primitive.zeros(count);
      for (int i = 0; i < count; i++) {
        Array.set(array, i, primitive.read(in));
      }
      return array;
    }
  }

  private record Structure(StructCodec codec, int minBytes) implements Element {

    @Override
    public Object read(XdrReader in) throws PlayerException {
      return codec.read(in);
    }

    @Override
    public void write(Object value, XdrWriter out) {
      codec.write(value, out);
    }

    @Override
    public Object readMany(int count, XdrReader in) throws PlayerException {
      List<Object> list = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        list.add(codec.read(in));
      }
      return List.copyOf(list);
    }
  }

  private final FieldLayout field;
  private final Element element;
  private final boolean bytes;

  private FieldCodec(FieldLayout field, Element element) {
    this.field = field;
    this.element = element;
    this.bytes = field.isArray() && field.primitive().filter(Primitive::isByte).isPresent();
  }

  static FieldCodec of(FieldLayout field, int index, Shape shape) {
    if (field.primitive().isPresent()) {
      return new FieldCodec(field, new Builtin(field.primitive().get()));
    }
    StructCodec nested = new StructCodec(field.struct().orElseThrow(), shape.nested(index, field));
    return new FieldCodec(field, new Structure(nested, nested.minBytes()));
  }

  int minBytes() {
    return switch (field.arity()) {
      case ONE -> element.minBytes();
      case FIXED -> bytes ? field.length() : field.length() * element.minBytes();
      default -> Integer.BYTES;
    };
  }

  /** Reads the value; {@code earlier} is the count that stood in an earlier place, if there is one. */
  Object read(XdrReader in, int earlier) throws PlayerException {
    return switch (field.arity()) {
      case ONE -> element.read(in);
      case FIXED -> many(field.length(), in);
      case COUNTED_EARLIER -> counted(earlier, in);
      default -> counted(in.count(1), in);
    };
  }

  private Object counted(int count, XdrReader in) throws PlayerException {
    in.sameCount(count);
    return many(count, in);
  }

  private Object many(int count, XdrReader in) throws PlayerException {
    int each = bytes ? 1 : element.minBytes();
    if ((long) count * each > in.remaining()) {
      throw new PlayerException(
          count + " elements of " + each + " bytes or more announced, but " + in.remaining() + " bytes follow");
    }
    return bytes ? in.bytes(count) : element.readMany(count, in);
  }

  void write(Object value, XdrWriter out) {
    if (field.arity() == FieldLayout.Arity.ONE) {
      element.write(value, out);
      return;
    }
    int length = length(value);
    switch (field.arity()) {
      case FIXED -> requireLength(length);
      case COUNTED_EARLIER -> out.i32(length);
      default -> out.i32(length).i32(length);
    }
    elements(value, length, out);
  }

  private void requireLength(int length) {
    if (length != field.length()) {
      throw new IllegalArgumentException(field.name() + " has " + field.length() + " elements, not " + length);
    }
  }

  private void elements(Object value, int length, XdrWriter out) {
    if (value instanceof byte[] packed) {
      out.bytes(packed);
      return;
    }
    for (int i = 0; i < length; i++) {
      element.write(value instanceof List<?> list ? list.get(i) : Array.get(value, i), out);
    }
  }

  static int length(Object value) {
    return value instanceof List<?> list ? list.size() : Array.getLength(value);
  }
}
