package org.robotui.condition;

/** What a part of a condition comes to. */
sealed interface Operand {
  /** As users read it. */
  String text();

  /**
   * A number.
   *
   * @param value it; what is not known is not a number
   * @param text as the robot said it
   */
  record Number(double value, String text) implements Operand {
    static Number of(double value) {
      return new Number(value, Double.toString(value));
    }
  }

  /** A word. */
  record Word(String text) implements Operand {}

  /** Whether something is so. */
  record Truth(boolean value) implements Operand {
    @Override
    public String text() {
      return Boolean.toString(value);
    }
  }

  /** It cannot be told; as of {@link Verdict.Unknown}. */
  record Missing(String reason, boolean wrong) implements Operand {
    @Override
    public String text() {
      return reason;
    }
  }
}
