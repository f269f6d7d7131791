package org.robotui.rfic.player.internal.link;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.time.ClockSource;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

/**
 * Reads the server's stamps and tells core the robot's time. Player does not say whose time they are; a simulator
 * counts from its start. What was decided by the first stamp holds until the link is lost. Safe for all threads.
 */
public final class Stamps {
  /** September 2001: no robot's clock is set before, no simulation runs for thirty years. */
  private static final double FIRST_OF_ROBOTS = 1e9;
  private static final double LAST = 9e9;
  private static final double NANOS = 1e9;
  private static final long NANOS_PER_MILLI = 1_000_000;

  /** Whose time the stamps are. */
  public enum Kind {
    /** It is found out. */
    AUTO,
    /** That of a robot. */
    ROBOT,
    /** That of a simulation. */
    SIMULATED;

    /** The kind by its word in configurations. */
    public static Kind of(String word) {
      return valueOf(word.toUpperCase(Locale.ROOT));
    }
  }

  private final ClockSource clock;
  private final Kind configured;
  private final AtomicReference<Optional<ClockKind>> decided = new AtomicReference<>(Optional.empty());

  public Stamps(ClockSource clock, Kind configured) {
    this.clock = clock;
    this.configured = configured;
  }

  /** The stamp of a message; 0 is how devices say that they have none. */
  public Optional<Stamp> of(double seconds) {
    if (!(seconds > 0) || seconds > LAST) {
      return Optional.empty();
    }
    ClockKind kind = decided.updateAndGet(known -> known.or(() -> Optional.of(decide(seconds)))).orElseThrow();
    long nanos = Math.round(seconds * NANOS);
    if (kind == ClockKind.SIMULATED) {
      clock.simulated(nanos);
    } else {
      clock.observed(nanos);
    }
    return Optional.of(new Stamp(nanos, kind));
  }

  /** For transforms of messages without a stamp. */
  public static Stamp wall() {
    return new Stamp(System.currentTimeMillis() * NANOS_PER_MILLI, ClockKind.ROBOT);
  }

  /** The link was lost: another server may answer next. */
  public void restart() {
    if (decided.getAndSet(Optional.empty()).filter(ClockKind.SIMULATED::equals).isPresent()) {
      clock.live();
    }
  }

  private ClockKind decide(double seconds) {
    boolean simulated = configured == Kind.SIMULATED || configured == Kind.AUTO && seconds < FIRST_OF_ROBOTS;
    return simulated ? ClockKind.SIMULATED : ClockKind.ROBOT;
  }
}
