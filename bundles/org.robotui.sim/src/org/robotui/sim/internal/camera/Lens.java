package org.robotui.sim.internal.camera;

/**
 * An ideal pinhole camera that looks along the robot's x axis.
 *
 * @param width pixels
 * @param height pixels
 * @param fieldOfView horizontal, radians
 * @param forward of the camera before the robot's centre, metres
 * @param above the floor, metres
 */
public record Lens(int width, int height, double fieldOfView, double forward, double above) {
  public static final Lens DEMO = new Lens(320, 240, Math.toRadians(72), 0.16, 0.62);

  /** In pixels, the same in both directions. */
  public double focalLength() {
    return width / 2.0 / Math.tan(fieldOfView / 2);
  }

  public double centreX() {
    return width / 2.0;
  }

  public double centreY() {
    return height / 2.0;
  }
}
