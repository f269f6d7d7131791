package org.robotui.message;

import java.util.Optional;

/**
 * The type of a field: a built-in or a message type, alone or as an array.
 *
 * @param base a built-in type's name or a message type's full name, without brackets
 * @param arity whether it is an array
 * @param length the number of elements of a fixed array, else 0
 */
public record FieldType(String base, Arity arity, int length) {

  /** How many values a field holds. */
  public enum Arity {
    /** Exactly one value. */
    ONE,
    /** An array whose length the definition gives. */
    FIXED,
    /** An array whose length is sent with it. */
    VARIABLE
  }

  /**
   * The built-in type of the value or of the elements.
   *
   * @return empty for a message type
   */
  public Optional<Primitive> primitive() {
    return Primitive.of(base);
  }

  /**
   * Whether the field is an array of either kind.
   *
   * @return false for a single value
   */
  public boolean isArray() {
    return arity != Arity.ONE;
  }

  /**
   * The type as definitions write it.
   *
   * @return such as {@code float64[36]}
   */
  @Override
  public String toString() {
    return switch (arity) {
      case ONE -> base;
      case FIXED -> base + "[" + length + "]";
      case VARIABLE -> base + "[]";
    };
  }
}
