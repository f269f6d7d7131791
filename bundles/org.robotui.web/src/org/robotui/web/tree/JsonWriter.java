package org.robotui.web.tree;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.lang.reflect.Array;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Map;

/** Writes a tree. */
record JsonWriter(JsonGenerator out) {

  void value(Object value) throws IOException {
    switch (value) {
      case null -> out.writeNull();
      case JsonNull none -> out.writeNull();
      case Boolean flag -> out.writeBoolean(flag);
      case CharSequence text -> out.writeString(text.toString());
      case Number number -> number(number);
      case byte[] bytes -> out.writeBinary(bytes);
      case Map<?, ?> members -> object(members);
      case Iterable<?> items -> array(items);
      case Object array when array.getClass().isArray() -> numbers(array);
      default -> throw new IllegalArgumentException("JSON has no " + value.getClass().getName());
    }
  }

  private void number(Number number) throws IOException {
    switch (number) {
      case Double real -> real(real);
      case Float real when Float.isFinite(real) -> out.writeNumber(real);
      case Float real -> out.writeNull();
      case BigInteger whole -> out.writeNumber(whole);
      case BigDecimal exact -> out.writeNumber(exact);
      default -> out.writeNumber(number.longValue());
    }
  }

  private void real(double real) throws IOException {
    if (Double.isFinite(real)) {
      out.writeNumber(real);
    } else {
      out.writeNull();
    }
  }

  private void object(Map<?, ?> members) throws IOException {
    out.writeStartObject();
    for (Map.Entry<?, ?> each : members.entrySet()) {
      out.writeFieldName(String.valueOf(each.getKey()));
      value(each.getValue());
    }
    out.writeEndObject();
  }

  private void array(Iterable<?> items) throws IOException {
    out.writeStartArray();
    for (Object each : items) {
      value(each);
    }
    out.writeEndArray();
  }

  private void numbers(Object array) throws IOException {
    out.writeStartArray();
    for (int i = 0; i < Array.getLength(array); i++) {
      value(Array.get(array, i));
    }
    out.writeEndArray();
  }
}
