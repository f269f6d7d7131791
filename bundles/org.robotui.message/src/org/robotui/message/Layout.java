package org.robotui.message;

import java.util.List;
import java.util.Optional;

/**
 * What decoding needs to know of a message type.
 *
 * @param type the full name
 * @param fields in the order on the wire
 * @param minSize the fewest bytes, saturated at {@link Long#MAX_VALUE}
 * @param fixedSize whether every message has exactly {@code minSize} bytes
 */
record Layout(String type, List<Field> fields, long minSize, boolean fixedSize) {

  /** Elements without bytes cannot be bounded by the bytes that are there. */
  static final int MAX_EMPTY_ELEMENTS = 1 << 16;

  /**
   * One field.
   *
   * @param name the name
   * @param type the type
   * @param primitive the built-in type of the value or of the elements, null for a message type
   * @param nested the layout of the message type, null for a built-in type
   * @param element the fewest bytes of the value or of one element
   * @param fixedElement whether every value or element has exactly that size
   * @param initial what a sender gives the field where nothing else is said, as written
   */
  record Field(String name, FieldType type, Primitive primitive, Layout nested, long element, boolean fixedElement,
      Optional<String> initial) {

    boolean isFixed() {
      return fixedElement && type.arity() != FieldType.Arity.VARIABLE;
    }

    /** The fewest bytes of the whole field. */
    long minSize() {
      return switch (type.arity()) {
        case ONE -> element;
        case FIXED -> saturatedProduct(element, type.length());
        case VARIABLE -> Integer.BYTES;
      };
    }
  }

  Optional<Field> field(String name) {
    return fields.stream().filter(f -> f.name().equals(name)).findFirst();
  }

  static long saturatedProduct(long a, long b) {
    long high = Math.multiplyHigh(a, b);
    long low = a * b;
    return high != 0 || low < 0 ? Long.MAX_VALUE : low;
  }

  static long saturatedSum(long a, long b) {
    return a > Long.MAX_VALUE - b ? Long.MAX_VALUE : a + b;
  }
}
