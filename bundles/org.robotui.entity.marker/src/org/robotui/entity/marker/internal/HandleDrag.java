package org.robotui.entity.marker.internal;

import java.util.Optional;
import org.robotui.data.marker.InteractiveMarker.Mode;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Ray;

/**
 * How a body moves that is gripped at a point and dragged under a ray, all in the fixed frame. Not safe for several
 * threads.
 */
final class HandleDrag {
  /** Below this angle between a ray and a plane, where they meet is too uncertain. */
  private static final double GRAZING = 0.02;

  private static final double FARTHEST = 1e4;
  private static final double NEAR_CENTER = 0.05;

  private final Mode mode;
  private final Vector3 axis;
  private final RigidTransform start;
  private final Vector3 place;
  private RigidTransform body;
  private Vector3 held;

  /**
   * Grips.
   *
   * @param mode what dragging does
   * @param axis of the control, unit length
   * @param body where the body is
   * @param place where it is gripped
   * @param ray under which it is gripped
   */
  HandleDrag(Mode mode, Vector3 axis, RigidTransform body, Vector3 place, Ray ray) {
    this.mode = mode;
    boolean free = mode == Mode.MOVE_3D || mode == Mode.MOVE_ROTATE_3D || mode == Mode.ROTATE_3D;
    this.axis = free ? ray.direction() : axis;
    this.start = body;
    this.place = place;
    this.body = body;
    this.held = place;
  }

  /** Where the body is when the ray has moved. */
  RigidTransform drag(Ray ray) {
    Optional<RigidTransform> moved = switch (mode) {
      case MOVE_AXIS -> along(ray);
      case MOVE_PLANE, MOVE_3D, MOVE_ROTATE_3D -> onPlane(ray).map(p -> moved(p.minus(place)));
      case ROTATE_AXIS -> onPlane(ray).flatMap(this::turned);
      case ROTATE_3D -> Optional.of(rolled(ray));
      case MOVE_ROTATE -> onPlane(ray).map(this::pulled);
      case NONE, MENU, BUTTON -> Optional.empty();
    };
    body = moved.filter(b -> b.translation().isFinite() && Double.isFinite(b.rotation().norm())).orElse(body);
    return body;
  }

  private RigidTransform moved(Vector3 by) {
    return new RigidTransform(start.translation().plus(by), start.rotation());
  }

  /** To the point of the axis that is nearest to the ray. */
  private Optional<RigidTransform> along(Ray ray) {
    Vector3 d = ray.direction();
    double both = axis.dot(d);
    double sine = 1 - both * both;
    if (sine < GRAZING * GRAZING) {
      return Optional.empty();
    }
    Vector3 gap = ray.origin().minus(place);
    double distance = (gap.dot(axis) - gap.dot(d) * both) / sine;
    return Math.abs(distance) > FARTHEST ? Optional.empty() : Optional.of(moved(axis.times(distance)));
  }

  /** Where the ray meets the plane through the grip that the axis is normal to. */
  private Optional<Vector3> onPlane(Ray ray) {
    double slope = ray.direction().dot(axis);
    double distance = place.minus(ray.origin()).dot(axis) / slope;
    boolean meets = Math.abs(slope) > GRAZING && distance > 0 && distance < FARTHEST;
    return meets ? Optional.of(ray.at(distance)) : Optional.empty();
  }

  private Vector3 flat(Vector3 v) {
    return v.minus(axis.times(v.dot(axis)));
  }

  private Optional<RigidTransform> turned(Vector3 to) {
    Vector3 from = flat(place.minus(start.translation()));
    Vector3 now = flat(to.minus(start.translation()));
    double angle = Math.atan2(axis.dot(from.cross(now)), from.dot(now));
    return from.norm() * now.norm() < 1e-12 ? Optional.empty() : Optional.of(turned(start, angle));
  }

  private RigidTransform turned(RigidTransform from, double angle) {
    return new RigidTransform(from.translation(), Turns.about(axis, angle).times(from.rotation()).normalized());
  }

  /** As a thing on a table that is pulled at a point: it turns after the hand. */
  private RigidTransform pulled(Vector3 to) {
    Vector3 arm = flat(held.minus(body.translation()));
    Vector3 pull = flat(to.minus(body.translation()));
    Vector3 step = to.minus(held);
    held = to;
    if (arm.norm() < NEAR_CENTER || pull.norm() < NEAR_CENTER) {
      return new RigidTransform(body.translation().plus(step), body.rotation());
    }
    double angle = Math.atan2(axis.dot(arm.cross(pull)), arm.dot(pull));
    Vector3 reach = pull.times(arm.norm() / pull.norm());
    return new RigidTransform(body.translation().plus(pull.minus(reach)), turned(body, angle).rotation());
  }

  /** As a ball that is turned by a finger on it. */
  private RigidTransform rolled(Ray ray) {
    Vector3 from = place.minus(start.translation());
    double radius = from.norm();
    if (radius < 1e-6) {
      return start;
    }
    Quaternion turn = Turns.between(from.times(1 / radius), onBall(ray, radius));
    return new RigidTransform(start.translation(), turn.times(start.rotation()).normalized());
  }

  private Vector3 onBall(Ray ray, double radius) {
    Vector3 gap = ray.origin().minus(start.translation());
    double along = -gap.dot(ray.direction());
    Vector3 nearest = gap.plus(ray.direction().times(along));
    double inside = radius * radius - nearest.dot(nearest);
    Vector3 touched = inside > 0 ? nearest.minus(ray.direction().times(Math.sqrt(inside))) : nearest;
    return touched.times(1 / touched.norm());
  }
}
