package org.robotui.lcm.type;

import java.util.List;
import java.util.stream.Stream;

/** Sees to it that a member is given what it can hold. */
final class Fitting {

  private Fitting() {}

  /** The value as the member holds it. */
  static LcmValue of(Slot slot, LcmValue value, String type) {
    boolean fits = slot.isArray() ? fitsArray(slot, value) : fitsSingle(slot, value);
    if (!fits) {
      throw new IllegalArgumentException(
          type + "." + slot.name() + " is declared as '" + slot.member() + "' and cannot hold " + brief(value));
    }
    return value instanceof LcmValue.Whole whole && slot.primitive().filter(Primitive::isFloating).isPresent()
        ? new LcmValue.Real(whole.value())
        : value;
  }

  private static boolean fitsSingle(Slot slot, LcmValue value) {
    return switch (slot.element()) {
      case Slot.Struct struct -> value instanceof LcmValue.Nested nested && isOf(struct, nested.value());
      case Slot.Builtin builtin -> fits(builtin.primitive(), value);
    };
  }

  private static boolean fits(Primitive type, LcmValue value) {
    return switch (value) {
      case LcmValue.Whole whole -> type.isFloating() || type.holds(whole.value());
      case LcmValue.Real real -> type.isFloating();
      case LcmValue.Flag flag -> type == Primitive.BOOLEAN;
      case LcmValue.Text text -> type == Primitive.STRING && isText(text.value());
      default -> false;
    };
  }

  private static boolean fitsArray(Slot slot, LcmValue value) {
    return switch (value) {
      case LcmValue.Numbers numbers -> slot.primitive().filter(type -> type == numbers.value().type()).isPresent();
      case LcmValue.Texts texts -> slot.primitive().filter(type -> type == Primitive.STRING).isPresent()
          && texts.values().stream().allMatch(Fitting::isText) && isFull(texts.shape(), texts.values().size());
      case LcmValue.Records records -> slot.element() instanceof Slot.Struct struct
          && isFull(records.shape(), records.values().size())
          && records.values().stream().allMatch(each -> isOf(struct, each));
      default -> false;
    };
  }

  /** Libraries have layouts of their own: what counts is that both mean the same type. */
  private static boolean isOf(Slot.Struct struct, LcmRecord record) {
    return struct.layout() == record.layout() || struct.layout().type().equals(record.type())
        && struct.layout().definition().members().toString().equals(record.members().toString());
  }

  private static boolean isText(String text) {
    return text.indexOf('\0') < 0;
  }

  private static boolean isFull(List<Integer> shape, int size) {
    return shape.stream().mapToLong(Integer::longValue).reduce(1, Slot::product) == size;
  }

  private static String brief(LcmValue value) {
    String text = switch (value) {
      case LcmValue.Nested nested -> "a " + nested.value().type();
      case LcmValue.Numbers numbers -> "an array of " + numbers.value();
      case LcmValue.Texts texts -> "texts " + texts.shape();
      case LcmValue.Records records -> "structs "
          + Stream.concat(records.values().stream().limit(1).map(LcmRecord::type),
              Stream.of(records.shape().toString())).toList();
      default -> value.toString();
    };
    return text.length() > 100 ? text.substring(0, 100) + "..." : text;
  }
}
