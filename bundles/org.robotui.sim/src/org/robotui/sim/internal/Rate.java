package org.robotui.sim.internal;

/**
 * Picks, out of the steps of the simulation, those with which something is published.
 *
 * @param hertz how often; at most as often as there are steps
 */
public record Rate(double hertz) {
  public static final Rate TRANSFORMS = new Rate(100);
  public static final Rate ODOMETRY = new Rate(50);
  public static final Rate IMU = new Rate(50);
  public static final Rate SONAR = new Rate(10);
  public static final Rate JOINTS = new Rate(20);
  public static final Rate CAMERA = new Rate(15);
  public static final Rate DEPTH = new Rate(10);
  public static final Rate LIDAR = new Rate(10);
  public static final Rate GOALS = new Rate(5);
  public static final Rate FIX = new Rate(5);
  public static final Rate FOOTPRINT = new Rate(10);
  public static final Rate ESTIMATE = new Rate(5);
  public static final Rate BATTERY = new Rate(1);
  public static final Rate DIAGNOSTICS = new Rate(1);
  public static final Rate OBJECTS = new Rate(2);
  public static final Rate SIGN_OF_LIFE = new Rate(2);
  public static final Rate PLAN = new Rate(1);

  public boolean isDue(long step) {
    double each = hertz * Simulation.STEP;
    return Math.floor(step * each + 1e-9) > Math.floor((step - 1) * each + 1e-9);
  }
}
