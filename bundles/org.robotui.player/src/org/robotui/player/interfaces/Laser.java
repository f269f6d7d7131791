package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Planar laser range-finders. Newer servers offer them as ranger, too. The interface {@code laser}. */
public final class Laser {

  /** Data: scan. */
  public static final Kind.Data<Scan> SCAN = new Kind.Data<>("laser", "scan", Scan.class);

  /** Data: posed scan. */
  public static final Kind.Data<PosedScan> POSED_SCAN = new Kind.Data<>("laser", "posed_scan", PosedScan.class);

  /** Data: angled scan. */
  public static final Kind.Data<AngledScan> ANGLED_SCAN = new Kind.Data<>("laser", "angled_scan", AngledScan.class);

  /** Request: get geometry; answered by {@link Body}. */
  public static final Kind.Request<Empty, Body> GET_GEOMETRY =
      new Kind.Request<>("laser", "get_geometry", Empty.class, Body.class);

  /** Request: set config with {@link Config}; answered by {@link Config}. */
  public static final Kind.Request<Config, Config> SET_CONFIG =
      new Kind.Request<>("laser", "set_config", Config.class, Config.class);

  /** Request: get config; answered by {@link Config}. */
  public static final Kind.Request<Empty, Config> GET_CONFIG =
      new Kind.Request<>("laser", "get_config", Empty.class, Config.class);

  /** Request: power by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> POWER =
      new Kind.Request<>("laser", "power", Switch.class, Empty.class);

  /** Request: get id; answered by {@link Id}. */
  public static final Kind.Request<Empty, Id> GET_ID = new Kind.Request<>("laser", "get_id", Empty.class, Id.class);

  /** Request: set filter by {@link Filter}; the answer is empty. */
  public static final Kind.Request<Filter, Empty> SET_FILTER =
      new Kind.Request<>("laser", "set_filter", Filter.class, Empty.class);

  private Laser() {}

  /**
   * One sweep; the rays are spread evenly from the least to the greatest angle.
   *
   * @param minAngle of the first ray, radians
   * @param maxAngle of the last ray, radians
   * @param resolution from ray to ray, radians
   * @param maxRange what is not less was not hit, metres
   * @param ranges one for each ray, metres
   * @param intensities one for each ray, in the device's unit, or none
   * @param id counts the sweeps
   */
  public record Scan(float minAngle, float maxAngle, float resolution, float maxRange, float[] ranges,
      byte[] intensities, long id) {}

  /**
   * One sweep and where the robot was then.
   *
   * @param scan the sweep
   * @param pose the robot's place
   */
  public record PosedScan(Scan scan, Pose2d pose) {}

  /**
   * One sweep of rays that are not spread evenly.
   *
   * @param maxRange what is not less was not hit, metres
   * @param ranges one for each ray, metres
   * @param angles one for each ray, radians
   * @param intensities one for each ray, in the device's unit, or none
   * @param id counts the sweeps
   */
  public record AngledScan(float maxRange, float[] ranges, float[] angles, byte[] intensities, long id) {}

  /**
   * How it measures.
   *
   * @param minAngle of the first ray, radians
   * @param maxAngle of the last ray, radians
   * @param resolution from ray to ray, radians
   * @param maxRange the farthest it sees, metres
   * @param rangeResolution of the distances, metres
   * @param intensity whether it sends intensities
   * @param frequency sweeps per second, hertz
   */
  public record Config(
      float minAngle, float maxAngle, float resolution, float maxRange, float rangeResolution, boolean intensity,
      float frequency) {}

  /**
   * Which one it is.
   *
   * @param serial the serial number
   */
  public record Id(long serial) {}

  /**
   * What smooths the distances.
   *
   * @param type 1 median, 2 edge, 3 range, 4 mean
   * @param parameters at most 8, as the type needs them
   */
  public record Filter(int type, float[] parameters) {}
}
