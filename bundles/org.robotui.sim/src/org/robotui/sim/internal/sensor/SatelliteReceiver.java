package org.robotui.sim.internal.sensor;

import java.util.random.RandomGenerator;
import org.robotui.sim.internal.world.Pose2;

/** Tells where on Earth the robot is; its error wanders slowly, as that of real receivers does. For one thread. */
public final class SatelliteReceiver {
  /** Standard deviation of each horizontal coordinate, metres. */
  public static final double ERROR = 0.4;
  private static final double MEMORY = 0.98;
  private static final double ORIGIN_LATITUDE = 48.26549;
  private static final double ORIGIN_LONGITUDE = 11.67128;
  private static final double ALTITUDE = 482.0;
  private static final double EQUATOR = 6378137.0;
  private static final double ECCENTRICITY_SQUARED = 6.69437999014e-3;

  private final RandomGenerator random;
  private double errorEast;
  private double errorNorth;
  private double errorUp;

  public SatelliteReceiver(RandomGenerator random) {
    this.random = random;
  }

  /**
   * A measured place.
   *
   * @param latitude degrees to the north
   * @param longitude degrees to the east
   * @param altitude metres above the ellipsoid
   */
  public record Fix(double latitude, double longitude, double altitude) {}

  /** The next measurement; x of the building points to the east. */
  public Fix measure(Pose2 robot) {
    errorEast = wander(errorEast, ERROR);
    errorNorth = wander(errorNorth, ERROR);
    errorUp = wander(errorUp, 2 * ERROR);
    return at(robot.x() + errorEast, robot.y() + errorNorth, errorUp);
  }

  private double wander(double error, double deviation) {
    return MEMORY * error + Math.sqrt(1 - MEMORY * MEMORY) * deviation * random.nextGaussian();
  }

  /** The place of a point of the building, metres to the east, to the north and up. */
  static Fix at(double east, double north, double up) {
    double sine = Math.sin(Math.toRadians(ORIGIN_LATITUDE));
    double w = Math.sqrt(1 - ECCENTRICITY_SQUARED * sine * sine);
    double meridian = EQUATOR * (1 - ECCENTRICITY_SQUARED) / (w * w * w);
    double parallel = EQUATOR / w * Math.cos(Math.toRadians(ORIGIN_LATITUDE));
    return new Fix(
        ORIGIN_LATITUDE + Math.toDegrees(north / meridian),
        ORIGIN_LONGITUDE + Math.toDegrees(east / parallel),
        ALTITUDE + up);
  }
}
