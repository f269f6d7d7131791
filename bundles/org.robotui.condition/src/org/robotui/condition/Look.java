package org.robotui.condition;

import java.util.Map;

/**
 * A look of a combined condition at the robot.
 *
 * @param signals what the robot said
 * @param active whether the alert is on
 * @param slack by how much numbers may be beyond their limits while it is on; negative under a {@code not}
 * @param seen takes what was looked at, by its name
 */
record Look(Signals signals, boolean active, double slack, Map<String, String> seen) {
  /** The same for what is turned round: what ends it there must not come early. */
  Look turned() {
    return new Look(signals, active, -slack, seen);
  }
}
