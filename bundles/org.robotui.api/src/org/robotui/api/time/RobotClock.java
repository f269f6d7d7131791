package org.robotui.api.time;

import java.time.Duration;
import java.util.Optional;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

/** The clock of one robot. Safe for all threads. */
public interface RobotClock {
  /**
   * The time.
   *
   * @return now, on this clock
   */
  Stamp now();

  /**
   * Whose clock this is at the moment.
   *
   * @return the kind
   */
  ClockKind kind();

  /**
   * How far the robot's clock is ahead of ours, as estimated from received stamps.
   *
   * @return the offset, or none where nothing stamped came yet
   */
  Optional<Duration> offset();

  /**
   * How often the clock has jumped back, or a recording was moved. A consumer that sees a new number forgets what it
   * has accumulated.
   *
   * @return 0 before the first jump
   */
  long epoch();
}
