package org.robotui.guard.internal.process;

import java.time.Duration;

/**
 * How long a guard waits, and how much it holds.
 *
 * @param late without a beat for so long, full connections are closed at once
 * @param silent without a beat for so long, all connections are closed and farewells are said
 * @param full a connection may be full for so long
 * @param chunks how many chunks of 64 KiB all connections may hold together
 * @param chunksEach how many one of them may hold
 * @param call for one farewell
 * @param calls for all farewells
 */
record Limits(Duration late, Duration silent, Duration full, int chunks, int chunksEach, Duration call,
    Duration calls) {

  /** A robot waits for half a second at most, and only where it sends more than 4 MiB meanwhile. */
  static Limits standard() {
    return new Limits(Duration.ofMillis(300), Duration.ofSeconds(2), Duration.ofMillis(500), 256, 64,
        Duration.ofSeconds(2),
        Duration.ofSeconds(5));
  }
}
