package org.robotui.message;

/** Carries a message of any type from one encoding into another, field by field. */
record Transcoder(FieldReader in, FieldWriter out) {

  void message(Layout layout) throws MessageException {
    for (Layout.Field each : layout.fields()) {
      if (each.nested() == null) {
        values(each);
      } else {
        messages(each);
      }
    }
  }

  private void messages(Layout.Field field) throws MessageException {
    int count = field.type().isArray() ? in.count(field.name(), LengthBounds.of(field.type()), field.element()) : 1;
    if (field.type().arity() == FieldType.Arity.VARIABLE) {
      out.array(count);
    }
    for (int i = 0; i < count; i++) {
      try {
        message(field.nested());
      } catch (MessageException e) {
        throw (field.type().isArray() ? e.within("[" + i + "]") : e).within(field.name());
      }
    }
  }

  private void values(Layout.Field field) throws MessageException {
    if (!field.type().isArray()) {
      single(field);
      return;
    }
    int length = LengthBounds.of(field.type());
    String name = field.name();
    ArrayWriter array = new ArrayWriter(name, length, 1);
    switch (field.primitive()) {
      case BOOL, INT8, UINT8, BYTE, CHAR -> array.write(in.bytes(name, length, 1), out);
      case INT16, UINT16 -> array.write(in.shorts(name, length, 1), out);
      case INT32, UINT32 -> array.write(in.ints(name, length, 1), out);
      case INT64, UINT64 -> array.write(in.longs(name, length, 1), out);
      case FLOAT32 -> array.write(in.floats(name, length, 1), out);
      case FLOAT64 -> array.write(in.doubles(name, length, 1), out);
      case STRING, WSTRING, TIME, DURATION -> singles(field, length);
    }
  }

  private void singles(Layout.Field field, int length) throws MessageException {
    int count = in.count(field.name(), length, field.element());
    if (length <= FieldReader.SENT) {
      out.array(count);
    }
    for (int i = 0; i < count; i++) {
      single(field);
    }
  }

  private void single(Layout.Field field) throws MessageException {
    String name = field.name();
    switch (field.primitive()) {
      case BOOL -> out.bool(in.bool(name));
      case INT8, UINT8, BYTE, CHAR -> out.u8(in.int8(name));
      case INT16, UINT16 -> out.i16(in.int16(name));
      case INT32, UINT32 -> out.i32(in.int32(name));
      case INT64, UINT64 -> out.i64(in.int64(name));
      case FLOAT32 -> out.f32(in.float32(name));
      case FLOAT64 -> out.f64(in.float64(name));
      case STRING -> out.string(bounded(field, in.string(name)));
      case WSTRING -> out.wstring(bounded(field, in.wstring(name)));
      case TIME -> out.stamp(in.time(name));
      case DURATION -> out.stamp(in.duration(name));
    }
  }

  private static String bounded(Layout.Field field, String text) throws MessageException {
    int most = field.type().textBound();
    return most == 0 ? text : LengthBounds.text(text, most, field.name());
  }
}
