package org.robotui.message;

import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * What a definition says of the length of an array, as one number: the length, {@link FieldReader#SENT} where it is
 * sent with the array, or {@code SENT - n} where it is sent and at most n.
 */
final class LengthBounds {

  private LengthBounds() {}

  static int of(FieldType type) {
    return type.arity() == FieldType.Arity.FIXED ? type.length() : FieldReader.SENT - type.bound();
  }

  /** The most elements of an array whose length is sent. */
  static int most(int length) {
    return length == FieldReader.SENT ? Integer.MAX_VALUE : FieldReader.SENT - length;
  }

  static String text(String value, int bytes, String field) throws MessageException {
    if (value.length() > bytes || value.getBytes(StandardCharsets.UTF_8).length > bytes) {
      throw new MessageException("a text is longer than the " + bytes + " bytes of the definition", field, 0);
    }
    return value;
  }

  /** The text, where its definition allows it; 0 stands for no bound. */
  static String written(String value, int bytes, String field) {
    if (bytes > 0 && value.getBytes(StandardCharsets.UTF_8).length > bytes) {
      throw new IllegalArgumentException(field + " has " + bytes + " bytes at most");
    }
    return value;
  }

  static List<String> texts(List<String> values, int bytes, String field) throws MessageException {
    for (String each : values) {
      text(each, bytes, field);
    }
    return values;
  }
}
