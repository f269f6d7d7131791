package org.robotui.uic.plot.internal.model;

import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * Which time is seen: live, up to now, or held. Changing it gives a new one.
 *
 * @param held what is looked at; none while live
 * @param zoomed seconds seen while live, in place of the configured ones
 */
public record TimeView(Optional<TimeSpan> held, OptionalDouble zoomed) {
  public static final TimeView LIVE = new TimeView(Optional.empty(), OptionalDouble.empty());

  private static final double SHORTEST = 1e-4;
  private static final double LONGEST = 30e6;

  public boolean isLive() {
    return held.isEmpty();
  }

  /**
   * The span that is seen.
   *
   * @param now the newest time
   * @param window configured seconds, 0 for all
   * @param all what there is; none before the first sample
   */
  public TimeSpan span(long now, double window, Optional<TimeSpan> all) {
    if (held.isPresent()) {
      return held.get();
    }
    if (zoomed.isEmpty() && window == 0) {
      return all.map(a -> new TimeSpan(Math.min(a.from(), now - TimeSpan.SECOND), Math.max(now, a.to())))
          .orElse(TimeSpan.until(now, 1));
    }
    return TimeSpan.until(now, zoomed.orElse(window));
  }

  /** Holds what is seen now. */
  public TimeView hold(TimeSpan seen) {
    return new TimeView(Optional.of(seen), zoomed);
  }

  /** Looks earlier or later. */
  public TimeView moved(TimeSpan seen, long nanos) {
    return hold(seen.moved(nanos));
  }

  /** Looks closer or from further away: while live the end stays now, else one time stays where it is. */
  public TimeView zoomed(TimeSpan seen, double factor, long fixed) {
    return isLive()
        ? new TimeView(held, OptionalDouble.of(Math.clamp(seen.seconds() * factor, SHORTEST, LONGEST)))
        : hold(seen.zoomed(factor, fixed));
  }
}
