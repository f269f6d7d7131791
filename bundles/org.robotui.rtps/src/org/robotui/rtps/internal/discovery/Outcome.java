package org.robotui.rtps.internal.discovery;

/** What became of an announcement. */
public sealed interface Outcome {

  /** It was not known. */
  record Found() implements Outcome {}

  /** It says something else than before. */
  record Changed() implements Outcome {}

  /** It says the same as before. */
  record Known() implements Outcome {}

  /**
   * It was not taken.
   *
   * @param reason for a person to read; names whom
   */
  record Refused(String reason) implements Outcome {}
}
