package org.robotui.rtps.internal.endpoint;

import java.time.Duration;

/**
 * When a writer asks its readers what they have: soon after it wrote, and ever more seldom while they do not answer.
 * Its writer's lock guards it.
 */
final class Beat {

  private static final long SHORTEST = Duration.ofMillis(20).toNanos();
  private static final long LONGEST = Duration.ofSeconds(1).toNanos();

  private long due = Timers.NEVER;
  private long pause = SHORTEST;

  long due() {
    return due;
  }

  /** Something is new that readers do not have. */
  void news(long now) {
    due = Math.min(due, now + SHORTEST);
  }

  /** It was asked; again if not all have all. */
  void asked(long now, boolean again) {
    due = again ? now + pause : Timers.NEVER;
    pause = Math.min(LONGEST, pause * 2);
  }

  /** A reader has more than before. */
  void progress(long now) {
    pause = SHORTEST;
    due = due == Timers.NEVER ? due : Math.min(due, now + pause);
  }
}
