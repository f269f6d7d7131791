package org.robotui.condition;

import java.util.Arrays;
import java.util.Optional;

/** Compares two numbers or words. */
enum Comparison {
  LESS("<"), AT_MOST("<="), GREATER(">"), AT_LEAST(">="), EQUAL("=="), DIFFERENT("!=");

  private final String sign;

  Comparison(String sign) {
    this.sign = sign;
  }

  static Optional<Comparison> find(String sign) {
    return Arrays.stream(values()).filter(each -> each.sign.equals(sign)).findFirst();
  }

  String sign() {
    return sign;
  }

  boolean ordered() {
    return this != EQUAL && this != DIFFERENT;
  }

  /** Compares; a slack makes it hold longer. What is not a number is only different. */
  boolean holds(double value, double limit, double slack) {
    return switch (this) {
      case LESS -> value < limit + slack;
      case AT_MOST -> value <= limit + slack;
      case GREATER -> value > limit - slack;
      case AT_LEAST -> value >= limit - slack;
      case EQUAL -> value == limit;
      case DIFFERENT -> value != limit;
    };
  }

  boolean holds(String value, String limit) {
    return value.equalsIgnoreCase(limit) == (this == EQUAL);
  }

  boolean holdsFor(Enum<?> value, Enum<?> limit) {
    return holds(value.ordinal(), limit.ordinal(), 0);
  }
}
