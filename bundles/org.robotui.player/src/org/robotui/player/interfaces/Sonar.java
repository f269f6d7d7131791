package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Rings of ultrasonic sensors. Newer servers offer them as ranger. The interface {@code sonar}. */
public final class Sonar {

  /** Data: ranges. */
  public static final Kind.Data<Ranges> RANGES = new Kind.Data<>("sonar", "ranges", Ranges.class);

  /** Data: geometry. */
  public static final Kind.Data<Geometry> GEOMETRY = new Kind.Data<>("sonar", "geometry", Geometry.class);

  /** Request: get geometry; answered by {@link Geometry}. */
  public static final Kind.Request<Empty, Geometry> GET_GEOMETRY =
      new Kind.Request<>("sonar", "get_geometry", Empty.class, Geometry.class);

  /** Request: power by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> POWER =
      new Kind.Request<>("sonar", "power", Switch.class, Empty.class);

  private Sonar() {}

  /**
   * One measurement of all sensors.
   *
   * @param ranges one for each sensor, metres
   */
  public record Ranges(float[] ranges) {}

  /**
   * Where the sensors are.
   *
   * @param poses one for each sensor, on the robot
   */
  public record Geometry(List<Pose3d> poses) {}
}
