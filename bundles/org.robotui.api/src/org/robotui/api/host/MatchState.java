package org.robotui.api.host;

/** What matching says of a port of a view. */
public enum MatchState {
  /** Data or commands can flow. */
  CONNECTED,
  /** Nothing there fits, or what was named does not. */
  REFUSED,
  /** Nothing there yet, it may come. */
  PENDING,
  /** Several fit where one is wanted. */
  AMBIGUOUS
}
