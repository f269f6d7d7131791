package org.robotui.rtps.internal.participant;

import java.time.Duration;
import org.robotui.rtps.Qos;
import org.robotui.rtps.internal.discovery.DiscoveredParticipants;
import org.robotui.rtps.internal.endpoint.Timers;

/** What a participant does in regular periods, on the thread of its timers. */
final class Upkeep {

  private final Timers timers;
  private final Attention attention;
  private final DiscoveredParticipants discovered;
  private final Announcer announcer;
  private final BuiltIns builtIns;
  private final Matching matching;

  Upkeep(Timers timers, Attention attention, DiscoveredParticipants discovered, Announcer announcer,
      BuiltIns builtIns, Matching matching) {
    this.timers = timers;
    this.attention = attention;
    this.discovered = discovered;
    this.announcer = announcer;
    this.builtIns = builtIns;
    this.matching = matching;
  }

  void start() {
    long now = timers.now();
    timers.timer(announcer::announce).wake(now);
    timers.timer(this::leases).wake(now);
    timers.timer(this::liveliness).wake(now);
  }

  private long leases(long now) {
    attention.look(now);
    discovered.expire(attention.now());
    return now + Attention.PERIOD;
  }

  private long liveliness(long now) {
    Duration lease = matching.shortestLease();
    if (Qos.infinite(lease)) {
      return now + Attention.PERIOD;
    }
    builtIns.sayAlive();
    return now + Math.min(Attention.PERIOD, lease.toNanos() / 3);
  }
}
