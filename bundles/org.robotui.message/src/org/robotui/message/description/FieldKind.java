package org.robotui.message.description;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.Primitive;

/** The numbers of types of fields: that of the element, plus one for how many there are. */
final class FieldKind {

  static final int NESTED = 1;
  static final int BOUNDED_STRING = 21;
  static final int BOUNDED_WSTRING = 22;

  static final int ONE = 0;
  static final int ARRAY = 48;
  static final int BOUNDED_SEQUENCE = 96;
  static final int SEQUENCE = 144;

  private static final Map<Primitive, Integer> NUMBERS = new EnumMap<>(Map.ofEntries(
      Map.entry(Primitive.INT8, 2), Map.entry(Primitive.UINT8, 3), Map.entry(Primitive.INT16, 4),
      Map.entry(Primitive.UINT16, 5), Map.entry(Primitive.INT32, 6), Map.entry(Primitive.UINT32, 7),
      Map.entry(Primitive.INT64, 8), Map.entry(Primitive.UINT64, 9), Map.entry(Primitive.FLOAT32, 10),
      Map.entry(Primitive.FLOAT64, 11), Map.entry(Primitive.BOOL, 15), Map.entry(Primitive.BYTE, 16),
      Map.entry(Primitive.STRING, 17), Map.entry(Primitive.WSTRING, 18)));

  /** Types that definitions in IDL may have beside those of messages: {@code char} is one byte without a sign. */
  private static final int CHARACTER = 13;

  private FieldKind() {}

  /** The number of a built-in type other than times; a {@code char} of a message is a number. */
  static int of(Primitive type, boolean bounded) {
    if (bounded) {
      return type == Primitive.WSTRING ? BOUNDED_WSTRING : BOUNDED_STRING;
    }
    return NUMBERS.get(type == Primitive.CHAR ? Primitive.UINT8 : type);
  }

  /** How many there are: one of the four numbers that are added. */
  static int arity(int typeId) {
    return typeId / ARRAY * ARRAY;
  }

  /** What a definition calls the elements of a type; empty where no definition of a message can say it. */
  static Optional<Primitive> primitive(int typeId) {
    int element = typeId % ARRAY;
    return switch (element) {
      case BOUNDED_STRING -> Optional.of(Primitive.STRING);
      case BOUNDED_WSTRING -> Optional.of(Primitive.WSTRING);
      case CHARACTER -> Optional.of(Primitive.UINT8);
      default -> NUMBERS.entrySet().stream().filter(each -> each.getValue() == element).map(Map.Entry::getKey)
          .findFirst();
    };
  }
}
