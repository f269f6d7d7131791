package org.robotui.condition;

/** What became of a condition. */
public sealed interface Verdict {
  /**
   * It is so.
   *
   * @param source what it is seen at, for example {@code battery.charge}
   * @param verb for example {@code is}
   * @param value what is seen, for example {@code 0.18}
   */
  record Holds(String source, String verb, String value) implements Verdict {
    /**
     * All of it as a sentence.
     *
     * @return for example {@code battery.charge is 0.18}
     */
    public String detail() {
      return source + " " + verb + " " + value;
    }
  }

  /** It is not so. */
  record Fails() implements Verdict {}

  /**
   * It cannot be told.
   *
   * @param reason what is missing
   * @param wrong whether the configuration must be wrong, and waiting does not help
   */
  record Unknown(String reason, boolean wrong) implements Verdict {}
}
