package org.robotui.sim.internal.player;

import org.robotui.sim.internal.RobotState;

/** Devices that belong together. */
interface Part extends AutoCloseable {
  /**
   * Sends what is due with a step to those who have the devices open.
   *
   * @param stamp when it was measured, seconds
   */
  void step(long step, RobotState state, double stamp);

  @Override
  default void close() {}
}
