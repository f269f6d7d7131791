package org.robotui.message;

import java.util.Optional;

/**
 * The type of a field: a built-in or a message type, alone or as an array.
 *
 * @param base a built-in type's name or a message type's full name, without brackets
 * @param arity whether it is an array
 * @param length the number of elements of a fixed array, else 0
 * @param bound the most elements of an array whose length is sent, 0 where there is no bound
 * @param textBound the most bytes of a text, 0 where there is no bound
 */
public record FieldType(String base, Arity arity, int length, int bound, int textBound) {

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
   * A type without bounds.
   *
   * @param base a built-in type's name or a message type's full name, without brackets
   * @param arity whether it is an array
   * @param length the number of elements of a fixed array, else 0
   */
  public FieldType(String base, Arity arity, int length) {
    this(base, arity, length, 0, 0);
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
   * @return such as {@code float64[36]} or {@code string<=10[<=5]}
   */
  @Override
  public String toString() {
    String element = textBound == 0 ? base : base + "<=" + textBound;
    return switch (arity) {
      case ONE -> element;
      case FIXED -> element + "[" + length + "]";
      case VARIABLE -> element + (bound == 0 ? "[]" : "[<=" + bound + "]");
    };
  }
}
