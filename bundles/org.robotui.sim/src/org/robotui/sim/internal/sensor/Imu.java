package org.robotui.sim.internal.sensor;

import java.util.random.RandomGenerator;
import org.robotui.sim.internal.robot.Speed;

/** A gyroscope and accelerometer with noise; its heading drifts slowly. For one thread. */
public final class Imu {
  public static final double GRAVITY = 9.80665;
  private static final double RATE_NOISE = 0.004;
  private static final double RATE_BIAS = 0.0004;
  private static final double ACCELERATION_NOISE = 0.03;

  private final RandomGenerator random;
  private Speed last = Speed.ZERO;
  private double heading;
  private double forward;
  private double sideways;
  private double turnRate;

  public Imu(RandomGenerator random) {
    this.random = random;
  }

  /** Takes in {@code dt} seconds at a true speed. */
  public void update(Speed speed, double dt) {
    turnRate = speed.angular() + RATE_BIAS + RATE_NOISE * random.nextGaussian();
    forward = (speed.linear() - last.linear()) / dt + ACCELERATION_NOISE * random.nextGaussian();
    sideways = speed.linear() * speed.angular() + ACCELERATION_NOISE * random.nextGaussian();
    heading += turnRate * dt;
    last = speed;
  }

  /** Radians since the start. */
  public double heading() {
    return heading;
  }

  /** Metres per second squared. */
  public double forward() {
    return forward;
  }

  /** Metres per second squared, to the left. */
  public double sideways() {
    return sideways;
  }

  /** Radians per second. */
  public double turnRate() {
    return turnRate;
  }
}
