package org.robotui.uic.scene3d.internal.camera;

import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Ray;

/**
 * Between places in space and in a picture.
 *
 * @param pose of the camera
 * @param width of the picture, in any unit
 * @param height of the picture, in the same unit
 */
public record Lens(CameraPose pose, double width, double height) {
  private static final double HALF = Math.tan(CameraPose.FIELD_OF_VIEW / 2);
  private static final double LEVEL = 1e-6;

  /** A place in a picture. */
  public record Spot(double x, double y) {}

  /** The line of sight under a spot, counted from the top left. */
  public Ray ray(double x, double y) {
    double side = (1 - 2 * x / width) * width / height;
    double rise = 1 - 2 * y / height;
    Quaternion turned = pose.rotation();
    if (pose.kind() == CameraKind.TOP) {
      Vector3 off = new Vector3(0, side, rise).times(pose.height() / 2);
      return new Ray(pose.eye().plus(turned.rotate(off)), pose.forward());
    }
    Vector3 direction = new Vector3(1, side * HALF, rise * HALF);
    return new Ray(pose.eye(), turned.rotate(direction.times(1 / direction.norm())));
  }

  /** Where a place is seen; none where it is behind the eye. */
  public Optional<Spot> spot(Vector3 place) {
    Vector3 seen = pose.rotation().inverse().rotate(place.minus(pose.eye()));
    boolean flat = pose.kind() == CameraKind.TOP;
    if (!flat && seen.x() <= 0) {
      return Optional.empty();
    }
    double scale = height / (flat ? pose.height() : 2 * HALF * seen.x());
    return Optional.of(new Spot(width / 2 - seen.y() * scale, height / 2 - seen.z() * scale));
  }

  /** Where the line of sight meets a level plane; none where it does not. */
  public Optional<Vector3> level(double x, double y, double z) {
    Ray ray = ray(x, y);
    if (Math.abs(ray.direction().z()) < LEVEL) {
      return Optional.empty();
    }
    double distance = (z - ray.origin().z()) / ray.direction().z();
    return distance > 0 || pose.kind() == CameraKind.TOP ? Optional.of(ray.at(distance)) : Optional.empty();
  }

  /** Metres that a unit of the picture shows at the focus. */
  public double metresPerUnit() {
    return pose.height() / height;
  }
}
