package org.robotui.core.internal.time;

/** The time by which values grow old: that of this machine, or that of a recording, which may stand still. */
public interface Ageing {
  /** By the monotonic clock of this machine. */
  static Ageing by(NanoClock clock) {
    return new Ageing() {
      @Override
      public long nanos() {
        return clock.nanos();
      }

      @Override
      public long at(long receivedNanos) {
        return receivedNanos;
      }
    };
  }

  /** Nanoseconds since some fixed moment. */
  long nanos();

  /** The same at a moment of the monotonic clock. */
  long at(long receivedNanos);
}
