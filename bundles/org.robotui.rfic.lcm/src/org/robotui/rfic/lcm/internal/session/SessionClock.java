package org.robotui.rfic.lcm.internal.session;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.lcm.LcmMessage;

/** Tells core the robot's time. That of a recording goes on as it is played, and is told as simulated time. */
final class SessionClock {
  private static final long NANOS_PER_MICRO = 1000;

  private final RficContext context;
  private final ClockKind kind;

  SessionClock(RficContext context, boolean recorded) {
    this.context = context;
    this.kind = recorded ? ClockKind.SIMULATED : ClockKind.ROBOT;
  }

  /** Notes that a message came. */
  void heard(LcmMessage message) {
    if (kind == ClockKind.SIMULATED) {
      context.clock().simulated(message.utime() * NANOS_PER_MICRO);
    }
  }

  /** The stamp that a message carries; 0 says that there is none. */
  Optional<Stamp> stamp(Optional<Long> nanos) {
    Optional<Stamp> stamp = nanos.filter(n -> n != 0).map(n -> new Stamp(n, kind));
    if (kind == ClockKind.ROBOT) {
      stamp.ifPresent(s -> context.clock().observed(s.nanos()));
    }
    return stamp;
  }

  /** For what must have a stamp: when the message was received or recorded. */
  Stamp received(LcmMessage message) {
    return new Stamp(message.utime() * NANOS_PER_MICRO, kind);
  }

  /** Nanoseconds since 1970, to put into commands. */
  static long now() {
    return ChronoUnit.NANOS.between(Instant.EPOCH, Instant.now());
  }
}
