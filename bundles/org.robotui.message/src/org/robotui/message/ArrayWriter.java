package org.robotui.message;

import java.nio.ByteBuffer;
import java.util.List;

/**
 * Writes an array of numbers or texts, after its length where that is sent.
 *
 * @param field for errors
 * @param length of the definition, or as {@link LengthBounds} has it
 * @param width how many numbers make an element
 */
record ArrayWriter(String field, int length, int width) {

  void write(ByteBuffer values, FieldWriter out) {
    start(values.remaining(), out);
    out.bytes(values);
  }

  void write(short[] values, FieldWriter out) {
    start(values.length, out);
    out.shorts(values);
  }

  void write(int[] values, FieldWriter out) {
    start(values.length, out);
    out.ints(values);
  }

  void write(long[] values, FieldWriter out) {
    start(values.length, out);
    out.longs(values);
  }

  void write(float[] values, FieldWriter out) {
    start(values.length, out);
    out.floats(values);
  }

  void write(double[] values, FieldWriter out) {
    start(values.length, out);
    out.doubles(values);
  }

  void texts(List<?> texts, Layout.Field field, FieldWriter out) {
    start(texts.size(), out);
    for (Object each : texts) {
      String text = LengthBounds.written((String) each, field.type().textBound(), field.name());
      if (field.primitive() == Primitive.WSTRING) {
        out.wstring(text);
      } else {
        out.string(text);
      }
    }
  }

  /** Checks how many numbers there are, and writes the length where it is sent. */
  void start(int numbers, FieldWriter out) {
    boolean sent = length <= FieldReader.SENT;
    if (sent ? numbers % width != 0 : numbers != length * width) {
      throw new IllegalArgumentException(field + (sent
          ? " has " + width + " values an element, not " + numbers + " in all"
          : " has " + length * width + " values, not " + numbers));
    }
    if (sent && numbers / width > LengthBounds.most(length)) {
      throw new IllegalArgumentException(
          field + " has " + LengthBounds.most(length) + " elements at most, not " + numbers / width);
    }
    if (sent) {
      out.array(numbers / width);
    }
  }

  /** A field that a record leaves out: numbers are zero, texts and arrays of variable length empty. */
  static void zero(Layout.Field field, FieldWriter out) {
    if (field.type().arity() == FieldType.Arity.VARIABLE) {
      out.array(0);
      return;
    }
    int count = field.type().isArray() ? field.type().length() : 1;
    for (int i = 0; i < count; i++) {
      if (field.nested() == null) {
        zero(field.primitive(), out);
      } else {
        field.nested().fields().forEach(each -> zero(each, out));
      }
    }
  }

  private static void zero(Primitive type, FieldWriter out) {
    switch (type) {
      case BOOL, INT8, UINT8, BYTE, CHAR -> out.u8(0);
      case INT16, UINT16 -> out.i16(0);
      case INT32, UINT32 -> out.i32(0);
      case INT64, UINT64 -> out.i64(0);
      case FLOAT32 -> out.f32(0);
      case FLOAT64 -> out.f64(0);
      case STRING -> out.string("");
      case WSTRING -> out.wstring("");
      case TIME, DURATION -> out.stamp(0);
    }
  }
}
