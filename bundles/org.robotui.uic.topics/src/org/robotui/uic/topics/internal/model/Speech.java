package org.robotui.uic.topics.internal.model;

import java.util.Optional;
import org.robotui.ui.Health;

/**
 * How saying messages is going.
 *
 * @param lease who may command the robot
 * @param asking whether the user is asked to take the robot over
 * @param hertz how often a message is repeated, none where it is not
 * @param said how many messages the robot's side took since the last beginning
 * @param health the dot of the outcome
 * @param outcome what became of the last message, empty before the first
 */
public record Speech(Lease lease, boolean asking, Optional<Double> hertz, long said, Health health, String outcome) {
  /** Who may command the robot. */
  public sealed interface Lease {
    /** Nobody does; the first message takes it. */
    record Free() implements Lease {}

    /** The user of this view. */
    record Mine() implements Lease {}

    /**
     * Somebody else.
     *
     * @param name who
     */
    record Other(String name) implements Lease {}
  }
}
