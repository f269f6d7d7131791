package org.robotui.api.host;

/** What came of an exchange. */
public sealed interface ExchangeOutcome {
  /** The new robot interface runs in the place of the old one. */
  record Done() implements ExchangeOutcome {}

  /**
   * Nothing was changed.
   *
   * @param reason sentences for users: what is missing
   */
  record Refused(String reason) implements ExchangeOutcome {}

  /**
   * The new one could not be started; the old one was started again.
   *
   * @param reason a sentence for users
   */
  record WentBack(String reason) implements ExchangeOutcome {}
}
