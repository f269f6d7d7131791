package org.robotui.sim.internal;

import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.world.GridMap;

/**
 * All that a face needs of a robot.
 *
 * @param simulation the robot in its building
 * @param sensors what it measures
 * @param map of the building
 * @param events what happens to it
 */
public record SimulatedRobot(Simulation simulation, Sensors sensors, GridMap map, Events events) {
  public RobotModel model() {
    return simulation.settings().robot();
  }

  public RobotState state() {
    return simulation.state();
  }
}
