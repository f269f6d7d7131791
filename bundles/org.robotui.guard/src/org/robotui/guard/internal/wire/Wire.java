package org.robotui.guard.internal.wire;

import java.time.Duration;

/**
 * The two ways to a guard. Its standard input, which nobody else can write to, begins with the two secrets, knock and
 * answer; then come frames of a byte that says what, and what belongs to it. Its port on loopback takes connections:
 * knock, length of address, address, port, milliseconds for connecting. It replies with the answer, so that nobody else
 * can pretend to be it, and a byte: {@link #DONE}, or {@link #REFUSED} with the reason.
 */
public final class Wire {
  /** Bytes of each secret. */
  public static final int SECRET = 32;
  /** We live. */
  public static final int BEAT = 'B';
  /** Keep words: id (4 bytes), length of address, address, port (2), length of words (4), words. */
  public static final int KEEP = 'K';
  /** Withdraw words: id (4). */
  public static final int WITHDRAW = 'W';
  /** End without a word. */
  public static final int GOODBYE = 'G';
  /** Connected; from here on the connection is the robot's. */
  public static final int DONE = 0;
  /** Not connected: the reason follows, as text with its length (2 bytes). */
  public static final int REFUSED = 1;
  /** The longest farewell. */
  public static final int MOST_WORDS = 64 * 1024;
  /** How many bytes all farewells may have. */
  public static final int ALL_WORDS = 4 << 20;
  /** How many farewells there may be. */
  public static final int MOST_FAREWELLS = 10_000;
  /** How often we say that we live. */
  public static final Duration BEATS = Duration.ofMillis(100);

  /** Said by the guard: its port. */
  public static final String PORT = "port ";
  /** Said by the guard: it heard a beat. */
  public static final String ECHO = ".";
  /** Said by the guard: a connection was closed since it was read too slowly. */
  public static final String OVERFLOW = "overflow ";
  /** Said by the guard: it heard no beats for too long. */
  public static final String SILENCE = "silence ";

  private Wire() {}
}
