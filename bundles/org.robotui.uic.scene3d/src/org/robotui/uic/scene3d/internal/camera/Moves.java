package org.robotui.uic.scene3d.internal.camera;

import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Ray;

/** How hands move a camera. Distances on the screen are in points. */
public final class Moves {
  private static final double RADIANS_PER_POINT = 0.006;
  /**
   * A key that is held down repeats some 30 times a second: so about half of what is seen in front of the eye passes in
   * one.
   */
  private static final double STEP = 0.02;

  private Moves() {}

  /** A drag that turns: round the focus, or of the eye where it flies, or of the plan. */
  public static CameraPose turn(CameraPose pose, double dx, double dy) {
    CameraPose turned = pose.looking(pose.yaw() - dx * RADIANS_PER_POINT, pose.pitch() + dy * RADIANS_PER_POINT);
    return switch (pose.kind()) {
      case ORBIT -> turned;
      case TOP -> pose.looking(pose.yaw() - dx * RADIANS_PER_POINT, pose.pitch());
      case FLY -> {
        // One looks along with the pointer, and the eye stays.
        CameraPose looked =
            pose.looking(pose.yaw() - dx * RADIANS_PER_POINT / 2, pose.pitch() + dy * RADIANS_PER_POINT / 2);
        yield looked.at(pose.eye().plus(looked.forward().times(pose.distance())));
      }
    };
  }

  /** A drag that moves what is seen along with the pointer. */
  public static CameraPose pan(Lens lens, double dx, double dy) {
    double metres = lens.metresPerUnit();
    CameraPose pose = lens.pose();
    return pose.at(pose.focus().plus(pose.left().times(dx * metres)).plus(pose.up().times(dy * metres)));
  }

  /** Nearer or farther; what is under the pointer stays there. A factor below 1 comes nearer. */
  public static CameraPose zoom(Lens lens, double x, double y, double factor) {
    CameraPose pose = lens.pose();
    if (pose.kind() == CameraKind.FLY) {
      Ray ray = lens.ray(x, y);
      return pose.at(pose.focus().plus(ray.direction().times(pose.distance() * (1 - factor))));
    }
    CameraPose nearer = pose.from(pose.distance() * factor);
    Vector3 held = held(lens, x, y);
    double real = nearer.distance() / pose.distance();
    return nearer.at(held.plus(pose.focus().minus(held).times(real)));
  }

  /** A step of the eye: forward, left, up, each -1, 0 or 1, times a factor. */
  public static CameraPose step(CameraPose pose, double forward, double left, double up) {
    double size = pose.distance() * STEP;
    Vector3 by = pose.forward().times(forward).plus(pose.left().times(left)).plus(new Vector3(0, 0, up));
    return pose.at(pose.focus().plus(by.times(size)));
  }

  private static Vector3 held(Lens lens, double x, double y) {
    CameraPose pose = lens.pose();
    Ray ray = lens.ray(x, y);
    double depth = pose.focus().minus(ray.origin()).dot(pose.forward()) / ray.direction().dot(pose.forward());
    return ray.at(depth);
  }
}
