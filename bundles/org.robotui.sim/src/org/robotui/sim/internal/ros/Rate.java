package org.robotui.sim.internal.ros;

import org.robotui.sim.internal.Simulation;

/**
 * Picks, out of the steps of the simulation, those with which something is published.
 *
 * @param hertz how often; at most as often as there are steps
 */
record Rate(double hertz) {
  static final Rate TRANSFORMS = new Rate(100);
  static final Rate ODOMETRY = new Rate(50);
  static final Rate IMU = new Rate(50);
  static final Rate SCAN = new Rate(20);
  static final Rate SONAR = new Rate(10);
  static final Rate JOINTS = new Rate(20);
  static final Rate CAMERA = new Rate(15);
  static final Rate DEPTH = new Rate(10);
  static final Rate LIDAR = new Rate(10);
  static final Rate GOALS = new Rate(5);
  static final Rate FIX = new Rate(5);
  static final Rate FOOTPRINT = new Rate(10);
  static final Rate ESTIMATE = new Rate(5);
  static final Rate BATTERY = new Rate(1);
  static final Rate DIAGNOSTICS = new Rate(1);
  static final Rate OBJECTS = new Rate(2);
  static final Rate SIGN_OF_LIFE = new Rate(2);
  static final Rate PLAN = new Rate(1);

  boolean isDue(long step) {
    double each = hertz * Simulation.STEP;
    return Math.floor(step * each + 1e-9) > Math.floor((step - 1) * each + 1e-9);
  }
}
