package org.robotui.rtps.internal.endpoint;

import java.time.Duration;

/**
 * When a reader says to a writer what it has and lacks: at once where the writer wants to know, soon where something is
 * missing, and ever more seldom while nothing changes. Its reader's lock guards it.
 */
final class Asking {

  /** Datagrams may overtake each other within this time. */
  private static final long OVERTAKING = Duration.ofMillis(2).toNanos();
  private static final long FIRST = Duration.ofMillis(20).toNanos();
  private static final long SHORTEST = Duration.ofMillis(5).toNanos();
  private static final long LONGEST = Duration.ofMillis(320).toNanos();
  /** A writer that never said anything may not be there. */
  private static final long SILENT = Duration.ofSeconds(2).toNanos();
  /** No writer is answered more often while something is missing. */
  private static final long LEAST = Duration.ofMillis(4).toNanos();
  /** An answer that takes more times as long as usual is lost. */
  private static final int PATIENCE = 3;

  private long due;
  private long last;
  private long usual = FIRST;
  private long pause = FIRST;
  private long asked = -1;
  private long lacked = -1;
  private boolean unanswered = true;

  /** The first time at once: the writer then says what it has. */
  Asking(long now) {
    due = now;
    last = now - FIRST;
  }

  /** The writer said what it has. */
  void answered() {
    if (unanswered) {
      unanswered = false;
      pause = FIRST;
    }
  }

  boolean unanswered() {
    return unanswered;
  }

  long due() {
    return due;
  }

  /** The writer wants to know. */
  void wanted(long now, boolean missing) {
    due = Math.min(due, missing ? Math.max(now, last + LEAST) : now);
  }

  /** Something is missing that may be on its way; the marker is another one where something came since then. */
  void missing(long now, long marker) {
    came(now, marker);
    due = Math.min(due, Math.max(now + OVERTAKING, last + pause));
  }

  /** Something came. */
  void came(long now, long marker) {
    if (asked >= 0 && marker != lacked) {
      usual = (3 * usual + Math.min(LONGEST, now - asked)) / 4;
      pause = Math.clamp(PATIENCE * usual, SHORTEST, LONGEST);
      asked = -1;
    }
  }

  /** It was said, and whether something is missing; then it is said again. */
  void said(long now, boolean again, long marker) {
    last = now;
    if (unanswered && !again) {
      pause = Math.min(SILENT, pause * 2);
    } else if (again && marker == lacked) {
      pause = Math.min(LONGEST, pause + pause / 2);
    } else if (again) {
      asked = now;
      lacked = marker;
    }
    due = again || unanswered ? now + pause : Timers.NEVER;
  }
}
