package org.robotui.smartsoft.naming;

import java.util.Arrays;
import java.util.Optional;

/** How services are used. */
public enum SmartPattern {
  /** Servers update those who have subscribed. Older releases tell newest and timed apart; the wire is the same. */
  PUSH("Push", 1),
  /** Clients say something. */
  SEND("Send", 1),
  /** Clients ask, servers answer. State, parameter and wiring are queries with objects of their own. */
  QUERY("Query", 2),
  /** Servers tell those who have activated an event when it happens. */
  EVENT("Event", 2);

  private final String word;
  private final int types;

  SmartPattern(String word, int types) {
    this.word = word;
    this.types = types;
  }

  static Optional<SmartPattern> of(String word, int types) {
    return Arrays.stream(values())
        .filter(each -> each.types == types && (word.equals(each.word) || each == PUSH && word.startsWith(each.word)))
        .findFirst();
  }

  /**
   * The word in names of services.
   *
   * @return such as {@code Push}
   */
  public String word() {
    return word;
  }
}
