package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Detectors of markers. The interface {@code fiducial}. */
public final class Fiducial {

  /** Data: scan. */
  public static final Kind.Data<Scan> SCAN = new Kind.Data<>("fiducial", "scan", Scan.class);

  /** Request: get geometry; answered by {@link Geometry}. */
  public static final Kind.Request<Empty, Geometry> GET_GEOMETRY =
      new Kind.Request<>("fiducial", "get_geometry", Empty.class, Geometry.class);

  /** Request: get fov; answered by {@link View}. */
  public static final Kind.Request<Empty, View> GET_FOV =
      new Kind.Request<>("fiducial", "get_fov", Empty.class, View.class);

  /** Request: set fov with {@link View}; answered by {@link View}. */
  public static final Kind.Request<View, View> SET_FOV =
      new Kind.Request<>("fiducial", "set_fov", View.class, View.class);

  /** Request: get id; answered by {@link Id}. */
  public static final Kind.Request<Empty, Id> GET_ID = new Kind.Request<>("fiducial", "get_id", Empty.class, Id.class);

  /** Request: set id with {@link Id}; answered by {@link Id}. */
  public static final Kind.Request<Id, Id> SET_ID = new Kind.Request<>("fiducial", "set_id", Id.class, Id.class);

  private Fiducial() {}

  /**
   * All markers in sight.
   *
   * @param markers in no order
   */
  public record Scan(List<Marker> markers) {}

  /**
   * A marker and where it is.
   *
   * @param id its number, -1 if it cannot be read
   * @param pose seen from the detector
   * @param uncertainty standard deviations of the pose
   */
  public record Marker(int id, Pose3d pose, Pose3d uncertainty) {}

  /**
   * Where the detector is, and what it looks for.
   *
   * @param pose on the robot
   * @param size of the detector
   * @param markerSize of the markers
   */
  public record Geometry(Pose3d pose, Size3d size, Size2d markerSize) {}

  /**
   * What it can see.
   *
   * @param minRange the nearest, metres
   * @param maxRange the farthest, metres
   * @param angle the field of view, radians
   */
  public record View(float minRange, float maxRange, float angle) {}

  /**
   * The marker that the robot itself shows.
   *
   * @param id its number
   */
  public record Id(long id) {}
}
