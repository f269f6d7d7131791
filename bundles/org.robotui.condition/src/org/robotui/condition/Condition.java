package org.robotui.condition;

import java.util.function.Predicate;
import org.robotui.api.port.Input;

/**
 * What may be so of a robot, such as that its battery is low. It may remember what it has seen: one is needed for each
 * robot, and used by one thread.
 */
public interface Condition {
  /**
   * Looks.
   *
   * @param signals what the robot said
   * @param active whether it held until now: it then ends later than it began, by its hysteresis
   * @return the verdict
   */
  Verdict check(Signals signals, boolean active);

  /**
   * Which streams it must be given.
   *
   * @return takes the streams that a robot offers
   */
  Predicate<Input.Candidate> needs();

  /**
   * Whether it is over as soon as it is told, so that it cannot last.
   *
   * @return true for what happens, such as an entry of a log
   */
  default boolean momentary() {
    return false;
  }
}
