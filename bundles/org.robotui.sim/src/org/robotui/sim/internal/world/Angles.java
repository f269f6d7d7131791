package org.robotui.sim.internal.world;

/** Arithmetic of angles in radians. */
public final class Angles {
  private Angles() {}

  /** The same angle in (-pi, pi]. */
  public static double wrap(double angle) {
    double wrapped = Math.IEEEremainder(angle, 2 * Math.PI);
    return wrapped <= -Math.PI ? wrapped + 2 * Math.PI : wrapped;
  }
}
