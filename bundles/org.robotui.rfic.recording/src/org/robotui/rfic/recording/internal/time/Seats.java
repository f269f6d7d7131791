package org.robotui.rfic.recording.internal.time;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.robotui.api.replay.TimeRange;

/** The places of all recordings that are open, by robot and instance. Guarded by their timeline. */
final class Seats {
  private static final Comparator<Seat> ORDER =
      Comparator.comparing((Seat seat) -> seat.track().id().robot())
          .thenComparing(seat -> seat.track().id().instance());

  private final List<Seat> all = new ArrayList<>();

  void add(Seat seat) {
    all.add(seat);
    all.sort(ORDER);
  }

  void remove(Seat seat) {
    all.remove(seat);
  }

  boolean isEmpty() {
    return all.isEmpty();
  }

  /** A copy. */
  List<Seat> all() {
    return List.copyOf(all);
  }

  TimeRange span() {
    return all.stream().map(Seat::span).reduce(TimeRange::with).orElse(new TimeRange(0, 0));
  }

  /** The first time that was not delivered yet. */
  long bound() {
    return all.stream().mapToLong(Seat::limit).min().orElse(Seat.NEVER);
  }

  boolean areThere() {
    return all.stream().noneMatch(Seat::isOnItsWay);
  }
}
