package org.robotui.uic.scene3d.internal.camera;

import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.shape.Box3;

/**
 * Where a camera is. All kinds share it, so that changing the kind keeps what is looked at.
 *
 * @param kind how it is moved
 * @param focus what it looks at, metres in the fixed frame
 * @param distance of the eye from the focus, metres
 * @param yaw where it looks, radians about z
 * @param pitch how far it looks down, radians
 */
public record CameraPose(CameraKind kind, Vector3 focus, double distance, double yaw, double pitch) {
  /** Angle from the bottom to the top of the picture. */
  public static final double FIELD_OF_VIEW = Math.toRadians(45);

  /** Before anything is known: some metres off, from behind and above. */
  public static final CameraPose START =
      new CameraPose(CameraKind.ORBIT, Vector3.ZERO, 10, Math.toRadians(30), Math.toRadians(35));

  /** Looking straight down, the x axis of the fixed frame points to the right. */
  public static final double TOP_YAW = Math.PI / 2;

  private static final double STRAIGHT_DOWN = Math.PI / 2;
  private static final double STEEPEST = STRAIGHT_DOWN - 1e-3;
  private static final double NEAREST = 0.02;
  private static final double FARTHEST = 1e6;
  private static final double HALF = Math.tan(FIELD_OF_VIEW / 2);
  private static final double DEPTHS = 1e5;
  /** What lies farther is seen from afar only, metres. */
  private static final double HORIZON = 1e4;
  private static final double LEAST_FIT = 0.2;
  private static final double MARGIN = 1.12;

  /** Keeps angles and distance in their ranges. */
  public CameraPose {
    distance = Math.clamp(Double.isNaN(distance) ? START_DISTANCE : distance, NEAREST, FARTHEST);
    pitch = Math.clamp(Double.isNaN(pitch) ? 0 : pitch, -STEEPEST, STEEPEST);
    yaw = Math.IEEEremainder(Double.isFinite(yaw) ? yaw : 0, 2 * Math.PI);
    focus = focus.isFinite() ? focus : Vector3.ZERO;
  }

  private static final double START_DISTANCE = 10;

  /** The same view in another kind. */
  public CameraPose as(CameraKind other) {
    if (other == CameraKind.TOP && kind != CameraKind.TOP) {
      return new CameraPose(other, focus, distance, TOP_YAW, pitch);
    }
    return new CameraPose(other, focus, distance, yaw, pitch);
  }

  /** Another focus. */
  public CameraPose at(Vector3 place) {
    return new CameraPose(kind, place, distance, yaw, pitch);
  }

  /** Another distance. */
  public CameraPose from(double metres) {
    return new CameraPose(kind, focus, metres, yaw, pitch);
  }

  /** Another direction. */
  public CameraPose looking(double newYaw, double newPitch) {
    return new CameraPose(kind, focus, distance, newYaw, newPitch);
  }

  /** How the eye is turned: x along the line of sight, y left, z up in the picture. */
  public Quaternion rotation() {
    return Quaternion.fromRollPitchYaw(0, kind == CameraKind.TOP ? STRAIGHT_DOWN : pitch, yaw);
  }

  /** The line of sight. */
  public Vector3 forward() {
    return rotation().rotate(new Vector3(1, 0, 0));
  }

  /** To the left in the picture. */
  public Vector3 left() {
    return rotation().rotate(new Vector3(0, 1, 0));
  }

  /** Up in the picture. */
  public Vector3 up() {
    return rotation().rotate(new Vector3(0, 0, 1));
  }

  /** Where the eye is. */
  public Vector3 eye() {
    return focus.minus(forward().times(distance));
  }

  /** What the picture shows from bottom to top at the focus, metres. */
  public double height() {
    return 2 * HALF * distance;
  }

  /** The eye for a renderer, with depths that hold what there is to see. */
  public Eye toEye(Optional<Box3> seen) {
    Box3 all = seen.orElse(new Box3(focus, focus)).union(new Box3(focus, focus));
    double beyond = all.center().minus(eye()).norm() + all.radius();
    if (kind == CameraKind.TOP) {
      Vector3 above = new Vector3(focus.x(), focus.y(),
          within(Math.max(focus.z() + distance, all.high().z() + 1), focus.z() + 2 * FARTHEST));
      double far = within(above.z() - all.low().z() + 1, 4 * FARTHEST);
      return new Eye(new RigidTransform(above, rotation()), new Eye.Projection.Parallel(height()), far / DEPTHS, far);
    }
    double far = within(Math.max(beyond, 2 * distance) * 1.05, Math.max(HORIZON, distance * DEPTHS / 50));
    double near = Math.clamp(distance / 50, far / DEPTHS, far / 10);
    return new Eye(new RigidTransform(eye(), rotation()), new Eye.Projection.Perspective(FIELD_OF_VIEW), near, far);
  }

  /** What shows all of a box in a picture of this shape, as large as it can be. */
  public CameraPose fit(Box3 box, double aspect) {
    Quaternion eyeFromFixed = rotation().inverse();
    double off = LEAST_FIT;
    for (int corner = 0; corner < 8; corner++) {
      Vector3 at = eyeFromFixed.rotate(corner(box, corner).minus(box.center()));
      double wide = Math.max(Math.abs(at.z()), Math.abs(at.y()) / aspect) / HALF;
      off = Math.max(off, kind == CameraKind.TOP ? wide : wide - at.x());
    }
    return new CameraPose(kind, box.center(), off * MARGIN, yaw, pitch);
  }

  /** The most where it is more, or no number: one thing that is infinitely far away must not hide what is near. */
  private static double within(double value, double most) {
    return value < most ? value : most;
  }

  private static Vector3 corner(Box3 box, int number) {
    return new Vector3((number & 1) == 0 ? box.low().x() : box.high().x(),
        (number & 2) == 0 ? box.low().y() : box.high().y(),
        (number & 4) == 0 ? box.low().z() : box.high().z());
  }

  /** Part of the way to another: 0 here, 1 there; turns the shorter way round. */
  public CameraPose toward(CameraPose other, double share) {
    double turn = Math.IEEEremainder(other.yaw - yaw, 2 * Math.PI);
    return new CameraPose(other.kind, focus.plus(other.focus.minus(focus).times(share)),
        distance * Math.pow(other.distance / distance, share), yaw + turn * share,
        pitch + (other.pitch - pitch) * share);
  }
}
