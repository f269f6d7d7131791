package org.robotui.rtps.internal.discovery;

/** What became of an announcement. */
public sealed interface Admission {

  /** It was not known. */
  record Found() implements Admission {}

  /** It says something else than before. */
  record Changed() implements Admission {}

  /** It says the same as before. */
  record Known() implements Admission {}

  /**
   * It was not taken.
   *
   * @param reason for a person to read; names whom
   */
  record Refused(String reason) implements Admission {}
}
