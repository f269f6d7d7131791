package org.robotui.uic.scene3d.internal.camera;

import java.util.Optional;
import java.util.function.UnaryOperator;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** The camera over time: short journeys, and a frame that is followed. Safe for all threads. */
public final class CameraMotion {
  /** How long a journey takes. */
  public static final long JOURNEY_NANOS = 250_000_000L;

  private CameraPose pose;
  private Optional<Journey> journey = Optional.empty();
  private Optional<RigidTransform> followed = Optional.empty();

  private record Journey(CameraPose from, long begunNanos) {}

  /** A camera at rest. */
  public CameraMotion(CameraPose start) {
    pose = start;
  }

  /** Where it is going, or is. */
  public synchronized CameraPose aim() {
    return pose;
  }

  /** Where it is now. */
  public synchronized CameraPose at(long nowNanos) {
    journey = journey.filter(j -> nowNanos - j.begunNanos() < JOURNEY_NANOS);
    return journey.map(j -> j.from().toward(pose, eased((nowNanos - j.begunNanos()) / (double) JOURNEY_NANOS)))
        .orElse(pose);
  }

  /** Whether it is on a journey. */
  public synchronized boolean travels(long nowNanos) {
    return journey.filter(j -> nowNanos - j.begunNanos() < JOURNEY_NANOS).isPresent();
  }

  /** Moves at once, by hand. */
  public synchronized void move(UnaryOperator<CameraPose> change) {
    journey = Optional.empty();
    pose = change.apply(pose);
  }

  /** Goes there on a short way. */
  public synchronized void go(CameraPose there, long nowNanos) {
    CameraPose here = at(nowNanos);
    journey = Optional.of(new Journey(here, nowNanos));
    pose = there;
  }

  /**
   * Keeps up with a frame.
   *
   * @param place where the frame is now; none ends following, or waits for it
   * @param turning whether to turn with it
   */
  public synchronized void follow(Optional<RigidTransform> place, boolean turning) {
    if (place.isPresent() && followed.isPresent()) {
      pose = moved(pose, followed.get(), place.get(), turning);
      journey = journey.map(j -> new Journey(moved(j.from(), followed.get(), place.get(), turning), j.begunNanos()));
    }
    followed = place;
  }

  private static CameraPose moved(CameraPose pose, RigidTransform before, RigidTransform now, boolean turning) {
    if (!turning) {
      return pose.at(pose.focus().plus(now.translation().minus(before.translation())));
    }
    double turn = now.rotation().yaw() - before.rotation().yaw();
    Vector3 off = pose.focus().minus(before.translation());
    Vector3 turned = RigidTransform.planar(0, 0, turn).apply(off);
    return pose.at(now.translation().plus(turned)).looking(pose.yaw() + turn, pose.pitch());
  }

  private static double eased(double share) {
    double s = Math.clamp(share, 0.0, 1.0);
    return s * s * (3 - 2 * s);
  }
}
