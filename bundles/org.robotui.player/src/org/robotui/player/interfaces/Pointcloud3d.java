package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Kind;

/** Points in space. The interface {@code pointcloud3d}. */
public final class Pointcloud3d {

  /** Data: state. */
  public static final Kind.Data<Cloud> STATE = new Kind.Data<>("pointcloud3d", "state", Cloud.class);

  private Pointcloud3d() {}

  /**
   * What is seen.
   *
   * @param points in the device's order
   */
  public record Cloud(List<Dot> points) {}

  /**
   * One point.
   *
   * @param point seen from the device
   * @param color its colour
   */
  public record Dot(Point3d point, Color color) {}
}
