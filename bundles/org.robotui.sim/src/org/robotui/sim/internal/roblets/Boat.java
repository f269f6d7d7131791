package org.robotui.sim.internal.roblets;

import java.util.Random;
import org.robotui.sim.internal.roblets.BoatMessages.Charge;
import org.robotui.sim.internal.roblets.BoatMessages.Heading;
import org.robotui.sim.internal.roblets.BoatMessages.Motion;
import org.robotui.sim.internal.roblets.BoatMessages.Position;
import org.robotui.sim.internal.roblets.BoatMessages.Wind;

/**
 * A boat of ten metres with sails, a motor and a rudder, off the coast of Pisa. It is as fast as wind and motor make
 * it, turns as fast as the water that passes its rudder lets it, and its instruments are not exact. Safe for all
 * threads.
 */
final class Boat {
  static final double START_LATITUDE = 43.66;
  static final double START_LONGITUDE = 10.24;
  static final double METRES_A_DEGREE = 111_320;
  static final double LARGEST_RUDDER = 35;

  private static final double MOTOR = 2.5; // m/s with full throttle
  private static final double SAIL = 0.2; // of the wind, at best
  private static final double INERTIA = 4; // s
  private static final double STEERING = 0.25; // rad/m with the rudder across
  private static final double RUDDER_RATE = 20; // deg/s
  private static final double CAPACITY = 3600 * 40.0; // A s

  private final Random random;
  private double time;
  private double x;
  private double y;
  private double yaw = Math.PI / 2;
  private double speed;
  private double turning;
  private double rudder;
  private double rudderWanted;
  private double throttle;
  private double used;

  Boat(long seed) {
    random = new Random(seed);
  }

  synchronized void step(double seconds) {
    time += seconds;
    double most = RUDDER_RATE * seconds;
    rudder += Math.clamp(rudderWanted - rudder, -most, most);
    double aim = MOTOR * throttle + sail();
    speed += (aim - speed) * seconds / INERTIA;
    double turn = -STEERING * speed * Math.sin(Math.toRadians(rudder));
    turning += (turn - turning) * seconds;
    yaw = Math.IEEEremainder(yaw + turning * seconds, 2 * Math.PI);
    x += speed * Math.cos(yaw) * seconds;
    y += speed * Math.sin(yaw) * seconds;
    used += current() * seconds;
  }

  private double windSpeed() {
    return 5 + 1.5 * Math.sin(time / 17) + 0.5 * Math.sin(time / 3);
  }

  /** From where it blows, radians from the east; it veers a bit. */
  private double windFrom() {
    return Math.toRadians(225 + 12 * Math.sin(time / 40));
  }

  private double windAngle() {
    return Math.IEEEremainder(yaw - windFrom(), 2 * Math.PI);
  }

  /** Nothing straight into the wind, the most across it and behind. */
  private double sail() {
    double off = Math.abs(windAngle());
    return SAIL * windSpeed() * Math.clamp((off - 0.6) / 0.6, 0.0, 1.0);
  }

  private double current() {
    return 1 + 30 * throttle;
  }

  synchronized void rudder(double degrees) {
    rudderWanted = Math.clamp(degrees, -LARGEST_RUDDER, LARGEST_RUDDER);
  }

  synchronized double rudder() {
    return rudder;
  }

  synchronized void throttle(double share) {
    throttle = Math.clamp(share, 0.0, 1.0);
  }

  synchronized double throttle() {
    return throttle;
  }

  synchronized Position position() {
    return new Position(START_LATITUDE + (y + noise(0.8)) / METRES_A_DEGREE,
        START_LONGITUDE + (x + noise(0.8)) / METRES_A_DEGREE / Math.cos(Math.toRadians(START_LATITUDE)), 1.5,
        Math.max(0, speed + noise(0.05)));
  }

  synchronized Heading heading() {
    double degrees = 90 - Math.toDegrees(yaw) + noise(0.5);
    return new Heading((degrees % 360 + 360) % 360, -Math.toDegrees(turning));
  }

  /** As it is felt on board: the boat's own speed comes from ahead. */
  synchronized Wind wind() {
    double ahead = windSpeed() * Math.cos(windAngle()) + speed;
    double across = windSpeed() * Math.sin(windAngle());
    return new Wind(Math.hypot(ahead, across) + noise(0.1), Math.toDegrees(Math.atan2(across, ahead)));
  }

  synchronized Motion motion() {
    return new Motion(x, y, yaw, speed, 0, turning);
  }

  synchronized Charge charge() {
    double left = Math.max(0, 1 - used / CAPACITY);
    return new Charge(11.5 + 1.3 * left, -current(), left);
  }

  private double noise(double deviation) {
    return random.nextGaussian() * deviation;
  }
}
