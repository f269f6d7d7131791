package org.robotui.uic.sound.internal.alert;

import java.util.function.Predicate;
import org.robotui.api.port.Input;

/** When an alert is due. Its state, if any, is used by one thread. */
public interface Condition {
  /**
   * Looks.
   *
   * @param signals what the robot said
   * @param active whether the alert is on: it then ends later than it began, by its hysteresis
   * @return the verdict
   */
  Verdict check(Signals signals, boolean active);

  /** Which streams it must be given. */
  Predicate<Input.Candidate> needs();

  /** Whether it is over as soon as it is told, so that it cannot last. */
  default boolean momentary() {
    return false;
  }
}
