package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Whatever measures distances: lasers, and rings of sonars or infrared sensors. The interface {@code ranger}. */
public final class Ranger {

  /** Data: ranges. */
  public static final Kind.Data<Ranges> RANGES = new Kind.Data<>("ranger", "ranges", Ranges.class);

  /** Data: stamped ranges. */
  public static final Kind.Data<StampedRanges> STAMPED_RANGES =
      new Kind.Data<>("ranger", "stamped_ranges", StampedRanges.class);

  /** Data: intensities. */
  public static final Kind.Data<Intensities> INTENSITIES = new Kind.Data<>("ranger", "intensities", Intensities.class);

  /** Data: stamped intensities. */
  public static final Kind.Data<StampedIntensities> STAMPED_INTENSITIES =
      new Kind.Data<>("ranger", "stamped_intensities", StampedIntensities.class);

  /** Data: geometry. */
  public static final Kind.Data<Geometry> GEOMETRY = new Kind.Data<>("ranger", "geometry", Geometry.class);

  /** Request: get geometry; answered by {@link Geometry}. */
  public static final Kind.Request<Empty, Geometry> GET_GEOMETRY =
      new Kind.Request<>("ranger", "get_geometry", Empty.class, Geometry.class);

  /** Request: power by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> POWER =
      new Kind.Request<>("ranger", "power", Switch.class, Empty.class);

  /** Request: intensity by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> INTENSITY =
      new Kind.Request<>("ranger", "intensity", Switch.class, Empty.class);

  /** Request: set config with {@link Config}; answered by {@link Config}. */
  public static final Kind.Request<Config, Config> SET_CONFIG =
      new Kind.Request<>("ranger", "set_config", Config.class, Config.class);

  /** Request: get config; answered by {@link Config}. */
  public static final Kind.Request<Empty, Config> GET_CONFIG =
      new Kind.Request<>("ranger", "get_config", Empty.class, Config.class);

  private Ranger() {}

  /**
   * One measurement.
   *
   * @param ranges one for each ray or sensor, metres
   */
  public record Ranges(double[] ranges) {}

  /**
   * How strong the echoes were.
   *
   * @param intensities one for each ray or sensor, in the device's unit
   */
  public record Intensities(double[] intensities) {}

  /**
   * Where the device and its sensors are.
   *
   * @param pose of the device, on the robot
   * @param size of the device
   * @param elementPoses one for each sensor, on the device; one or none for a scanner
   * @param elementSizes one for each sensor
   */
  public record Geometry(Pose3d pose, Size3d size, List<Pose3d> elementPoses, List<Size3d> elementSizes) {}

  /**
   * How it measures; what a device does not know is 0.
   *
   * @param minAngle of the first ray, radians
   * @param maxAngle of the last ray, radians
   * @param resolution from ray to ray, radians
   * @param minRange what is less is no measurement, metres
   * @param maxRange the farthest it sees, metres
   * @param rangeResolution of the distances, metres
   * @param frequency measurements per second, hertz
   */
  public record Config(
      double minAngle, double maxAngle, double resolution, double minRange, double maxRange, double rangeResolution,
      double frequency) {}

  /**
   * One measurement with all that belongs to it.
   *
   * @param data the distances
   * @param hasGeometry whether the geometry is filled
   * @param geometry at that time
   * @param hasConfig whether the configuration is filled
   * @param config at that time
   */
  public record StampedRanges(Ranges data, boolean hasGeometry, Geometry geometry, boolean hasConfig, Config config) {}

  /**
   * How strong the echoes were, with all that belongs to it.
   *
   * @param data the echoes
   * @param hasGeometry whether the geometry is filled
   * @param geometry at that time
   * @param hasConfig whether the configuration is filled
   * @param config at that time
   */
  public record StampedIntensities(Intensities data, boolean hasGeometry, Geometry geometry, boolean hasConfig,
      Config config) {}
}
