package org.robotui.workbench.internal.timeline;

import java.util.ArrayList;
import java.util.List;

/** Round times after the start of the recordings, with labels that tell neighbours apart. */
final class ElapsedTicks {
  private static final long DAY = TimeWords.DAY;
  private static final int MOST = 200;
  private static final long[] ROUND = {
      TimeWords.SECOND, 2 * TimeWords.SECOND, 5 * TimeWords.SECOND, 10 * TimeWords.SECOND, 15 * TimeWords.SECOND,
      30 * TimeWords.SECOND, TimeWords.MINUTE, 2 * TimeWords.MINUTE, 5 * TimeWords.MINUTE, 10 * TimeWords.MINUTE,
      15 * TimeWords.MINUTE, 30 * TimeWords.MINUTE, TimeWords.HOUR, 2 * TimeWords.HOUR, 3 * TimeWords.HOUR,
      6 * TimeWords.HOUR, 12 * TimeWords.HOUR, DAY
  };

  private ElapsedTicks() {}

  /** One of them. */
  record Tick(long time, String label) {}

  /**
   * Those within a scale.
   *
   * @param scale what is shown
   * @param origin from which they count
   * @param distance how far apart they are at least, points
   */
  static List<Tick> of(TimeScale scale, long origin, int distance) {
    long step = step(Math.round((double) scale.shown().length() / scale.width() * distance));
    int decimals = decimals(step);
    List<Tick> ticks = new ArrayList<>();
    long first = Math.ceilDiv(scale.shown().start() - origin, step);
    long last = Math.min(first + MOST, Math.floorDiv(scale.shown().end() - origin, step));
    for (long i = first; i <= last; i++) {
      ticks.add(new Tick(origin + i * step, TimeWords.elapsed(i * step, decimals)));
    }
    return ticks;
  }

  /** The smallest round step that is not below a length of time. */
  static long step(long least) {
    for (long power = 1; power < TimeWords.SECOND; power *= 10) {
      for (long step = power; step <= 5 * power; step += step == power ? power : 3 * power) {
        if (step >= least) {
          return step;
        }
      }
    }
    for (long step : ROUND) {
      if (step >= least) {
        return step;
      }
    }
    long days = Math.min(Math.ceilDiv(least, DAY), Long.MAX_VALUE / DAY);
    return days * DAY;
  }

  /** How many decimals of a second tell steps apart. */
  private static int decimals(long step) {
    int decimals = 0;
    for (long unit = TimeWords.SECOND; decimals < 9 && step % unit != 0; unit /= 10) {
      decimals++;
    }
    return decimals;
  }
}
