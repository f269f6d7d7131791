package org.robotui.core.internal.command;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.core.internal.time.NanoClock;

/** Knows whether the display thread lives and whether the user's attention is with our windows. */
public final class DisplayWatch {
  /** A silence after which nothing keeps moving. */
  public static final long SILENCE_NANOS = 200_000_000L;

  private record Beat(Thread thread, long nanos) {}

  private final NanoClock clock;
  private final AtomicLong longest = new AtomicLong();
  private volatile Optional<Beat> last = Optional.empty();
  private volatile boolean focused = true;
  private volatile boolean stopped;

  /** A watch for an application that may have no display. */
  public DisplayWatch(NanoClock clock) {
    this.clock = clock;
  }

  /** The calling thread is the display thread, and it lives. */
  public void alive() {
    longest.accumulateAndGet(silenceNanos(), Math::max);
    last = Optional.of(new Beat(Thread.currentThread(), clock.nanos()));
  }

  /** Whether one of our windows has the focus. */
  public void focus(boolean has) {
    focused = has;
  }

  /** The display thread, once it has called. */
  public Optional<Thread> thread() {
    return last.map(Beat::thread);
  }

  /** How long the display has been silent; 0 where there is none. */
  public long silenceNanos() {
    return last.map(b -> Math.max(0, clock.nanos() - b.nanos())).orElse(0L);
  }

  /**
   * The longest silence that has ended since the last call: who looks now and then misses how long it was. For one
   * caller.
   */
  public long takeLongestSilenceNanos() {
    return longest.getAndSet(0);
  }

  /** Something that a window moved has been stopped because the display is silent. */
  public void stoppedSomething() {
    stopped = true;
  }

  /** Whether that has happened since the last call. For one caller. */
  public boolean takeStopped() {
    boolean was = stopped;
    stopped = false;
    return was;
  }

  boolean isSilent() {
    return silenceNanos() > SILENCE_NANOS;
  }

  /** Why a person at a window cannot be trusted to see what moves; nothing where all is well. */
  Optional<String> unattended() {
    long silence = silenceNanos();
    if (silence > SILENCE_NANOS) {
      return Optional.of(String.format(Locale.ROOT, "the display has not answered for %.1f s", silence * 1e-9));
    }
    return focused ? Optional.empty() : Optional.of("the window has lost the focus");
  }

  /** When the display will count as silent if it says nothing more. */
  long silentAtNanos() {
    return last.map(b -> b.nanos() + SILENCE_NANOS + 1).orElse(Long.MAX_VALUE);
  }
}
