package org.robotui.roblets.wire;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What a datagram is for. */
public enum DatagramKind {
  /** A roblet tells the brain that it is there, what it says and takes, and how it is. */
  BEACON,
  /** The brain answers a beacon or a watch. */
  WELCOME,
  /** A roblet says something to its brain or a friend, or the brain to a roblet; watchers get the same bytes. */
  MESSAGE,
  /** Somebody wants to see what roblets say, for some seconds. */
  WATCH,
  /** The brain tells a watcher of one roblet. */
  ROSTER,
  /** A watcher asks the brain to say something to a roblet. */
  REQUEST,
  /** A roblet or a watcher goes. */
  LEAVE;

  /**
   * As it is written.
   *
   * @return in small letters
   */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  static Optional<DatagramKind> of(String word) {
    return Arrays.stream(values()).filter(kind -> kind.word().equals(word)).findFirst();
  }
}
