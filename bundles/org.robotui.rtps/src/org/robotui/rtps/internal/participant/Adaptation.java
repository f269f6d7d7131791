package org.robotui.rtps.internal.participant;

import java.time.Duration;
import java.util.List;
import org.robotui.rtps.History;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reliability;

/** What a reader requests so that all writers of its topic offer it. */
final class Adaptation {

  private Adaptation() {}

  /** The preferred quality, lowered to what each of the writers offers. */
  static Qos of(Qos preferred, List<Qos> offered) {
    Qos requested = preferred;
    for (Qos offer : offered) {
      requested = lowered(requested, offer);
    }
    return requested;
  }

  private static Qos lowered(Qos requested, Qos offer) {
    Liveliness liveliness = least(requested.liveliness(), offer.liveliness());
    return new Qos(least(requested.reliability(), harmless(offer)), least(requested.durability(), offer.durability()),
        requested.history(), requested.depth(), most(requested.deadline(), offer.deadline()), requested.lifespan(),
        liveliness, most(requested.livelinessLease(), offer.livelinessLease()), offer.ownership(),
        requested.partitions(), requested.representations());
  }

  /** A writer that keeps all waits for who is slow to acknowledge, also for a reader that is stopped. */
  private static Reliability harmless(Qos offer) {
    return offer.history() == History.KEEP_ALL ? Reliability.BEST_EFFORT : offer.reliability();
  }

  private static <E extends Enum<E>> E least(E one, E other) {
    return one.compareTo(other) <= 0 ? one : other;
  }

  private static Duration most(Duration one, Duration other) {
    return one.compareTo(other) >= 0 ? one : other;
  }
}
