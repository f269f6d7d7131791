package org.robotui.roboframe.app;

import java.time.Duration;

/** When a module runs. */
public sealed interface RunPace {

  /**
   * Again and again; turns that were missed are left out.
   *
   * @param period from one to the next
   */
  record Cyclic(Duration period) implements RunPace {

    /** Refuses what is no period with an {@link IllegalArgumentException}. */
    public Cyclic {
      if (period.isNegative() || period.isZero()) {
        throw new IllegalArgumentException("a period must be longer than " + period);
      }
    }
  }

  /** Whenever a key that it requested has a new value; several that come meanwhile are one reason. */
  record OnChange() implements RunPace {}
}
