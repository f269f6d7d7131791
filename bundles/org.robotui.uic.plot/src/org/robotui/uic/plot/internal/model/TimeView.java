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

  /**
   * The span that is seen of recordings: what is held; else a span that goes along with the position of the timeline;
   * else all.
   *
   * @param position where the timeline is
   * @param all of the recordings
   */
  public TimeSpan played(long position, TimeSpan all) {
    if (held.isPresent()) {
      return held.get();
    }
    return isFollowing()
        ? TimeSpan.until(position, zoomed.getAsDouble()).moved(TimeSpan.nanos(zoomed.getAsDouble()) / 2)
        : all.widened();
  }

  /** Whether it goes along with the position of the timeline. */
  public boolean isFollowing() {
    return held.isEmpty() && zoomed.isPresent();
  }

  /** Goes along with the position of the timeline. */
  public static TimeView following(double seconds) {
    return new TimeView(Optional.empty(), OptionalDouble.of(Math.clamp(seconds, SHORTEST, LONGEST)));
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
