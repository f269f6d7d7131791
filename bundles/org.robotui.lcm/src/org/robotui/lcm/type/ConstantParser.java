package org.robotui.lcm.type;

import java.util.OptionalDouble;
import java.util.OptionalLong;

/** Reads the values of constants. */
final class ConstantParser {

  private ConstantParser() {}

  static ConstantDefinition parse(String name, Primitive type, Token value) throws TypeException {
    return new ConstantDefinition(name, type, type.isFloating() ? real(type, value) : whole(type, value), value.text());
  }

  private static Number whole(Primitive type, Token token) throws TypeException {
    OptionalLong value = Numerals.whole(token.text());
    if (value.isEmpty() || !type.holds(value.getAsLong())) {
      throw new TypeException(token.place(), token.quoted() + " is no " + type.lcmName(),
          "write an integer of " + type.size() * Byte.SIZE + " bits, such as -1 or 0x1f");
    }
    return value.getAsLong();
  }

  private static Number real(Primitive type, Token token) throws TypeException {
    OptionalDouble value = Numerals.real(token.text());
    if (value.isEmpty()
        || Double.isInfinite(type == Primitive.FLOAT ? (float) value.getAsDouble() : value.getAsDouble())) {
      throw new TypeException(token.place(), token.quoted() + " is no " + type.lcmName(),
          "write a number such as 2.5 or 1e-3");
    }
    return value.getAsDouble();
  }
}
