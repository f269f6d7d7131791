package org.robotui.rfic.recording.internal.time;

/**
 * A time that stands, or passes at some speed. Times are nanoseconds, those of the real clock of
 * {@link System#nanoTime()}. Guarded by its timeline.
 */
final class PlayClock {
  private long position;
  private long since;
  private double speed = 1;
  private boolean playing;

  /** The time at a moment of the real clock. */
  long at(long now) {
    return playing ? position + (long) ((now - since) * speed) : position;
  }

  /** The same, where it stops at a time unless it began behind it. */
  long at(long now, long end) {
    return Math.min(at(now), Math.max(position, end));
  }

  /** Goes to a time, and goes on from there where it plays. */
  void place(long time, long now) {
    position = time;
    since = now;
  }

  /** Lets it pass or stand, from where it is. */
  void play(boolean passes, long now) {
    place(at(now), now);
    playing = passes;
  }

  void speed(double factor, long now) {
    place(at(now), now);
    speed = factor;
  }

  double speed() {
    return speed;
  }

  boolean isPlaying() {
    return playing;
  }

  /** How long the real clock needs to bring it to a time; the largest number where it stands. */
  long realNanosUntil(long time, long now) {
    double left = (double) time - at(now);
    return playing ? (long) Math.min(Long.MAX_VALUE, Math.max(0, left / speed)) : Long.MAX_VALUE;
  }
}
