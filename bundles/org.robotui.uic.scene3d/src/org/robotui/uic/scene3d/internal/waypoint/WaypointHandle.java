package org.robotui.uic.scene3d.internal.waypoint;

import java.util.List;
import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Handle;
import org.robotui.gl.shape.Ray;

/**
 * A waypoint in the hand of a user: its disc moves it over the level on which it lies, its arrow turns it. Worker
 * thread.
 */
final class WaypointHandle implements Handle {
  private static final int REMOVE = 1;
  private static final int EARLIER = 2;
  private static final int LATER = 3;
  private static final int DRIVE = 4;
  private static final double GRAZING = 0.02;
  private static final double FARTHEST = 1e4;

  private final Waypoints waypoints;
  private final int index;
  private final boolean turns;
  private Optional<Pressed> pressed = Optional.empty();

  WaypointHandle(Waypoints waypoints, int index, boolean turns) {
    this.waypoints = waypoints;
    this.index = index;
    this.turns = turns;
  }

  /** Where it was gripped, in the fixed frame. */
  private record Pressed(RigidTransform start, Vector3 place) {}

  @Override
  public void press(Ray ray, Vector3 place) {
    pressed = waypoints.place(index).map(start -> new Pressed(start, place));
  }

  @Override
  public void drag(Ray ray) {
    pressed.ifPresent(p -> level(ray, p.place.z())
        .ifPresent(at -> waypoints.hold(index, turns ? turned(p.start, at) : moved(p, at))));
  }

  @Override
  public void release(boolean clicked) {
    pressed = Optional.empty();
    if (!clicked) {
      waypoints.release();
    }
  }

  @Override
  public List<Choice> menu() {
    int last = waypoints.route().poses().size() - 1;
    List<Choice> all = List.of(choice(REMOVE, "Remove (Del)"), choice(EARLIER, "Earlier (Page up)"),
        choice(LATER, "Later (Page down)"),
        choice(DRIVE, "Drive from here on"));
    return all.stream().filter(c -> (c.id() != EARLIER || index > 0) && (c.id() != LATER || index < last)).toList();
  }

  @Override
  public void choose(int id) {
    switch (id) {
      case REMOVE -> waypoints.remove(index);
      case EARLIER -> waypoints.move(index, -1);
      case LATER -> waypoints.move(index, 1);
      case DRIVE -> waypoints.tour().start(index);
      default -> {}
    }
  }

  private static Choice choice(int id, String label) {
    return new Choice(id, label, false, List.of());
  }

  private static RigidTransform moved(Pressed pressed, Vector3 at) {
    return new RigidTransform(pressed.start.translation().plus(at.minus(pressed.place)), pressed.start.rotation());
  }

  private static RigidTransform turned(RigidTransform start, Vector3 at) {
    Vector3 ahead = at.minus(start.translation());
    return new RigidTransform(start.translation(), Quaternion.fromYaw(Math.atan2(ahead.y(), ahead.x())));
  }

  private static Optional<Vector3> level(Ray ray, double z) {
    double distance = (z - ray.origin().z()) / ray.direction().z();
    boolean meets = Math.abs(ray.direction().z()) > GRAZING && distance > 0 && distance < FARTHEST;
    return meets ? Optional.of(ray.at(distance)) : Optional.empty();
  }
}
