package org.robotui.sim.internal.world;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The building, as the robot's body and its sensors meet it. Immutable, for any thread. */
public final class World {
  private final FloorPlan plan;
  private final Solid[] solids;

  public World(FloorPlan plan) {
    this(plan, plan.solids().toArray(Solid[]::new));
  }

  private World(FloorPlan plan, Solid[] solids) {
    this.plan = plan;
    this.solids = solids;
  }

  /** The same building with something more in it. */
  public World with(Solid visitor) {
    Solid[] more = Arrays.copyOf(solids, solids.length + 1);
    more[solids.length] = visitor;
    return new World(plan, more);
  }

  /** The corners of the way that somebody walks; empty if nobody does. */
  public List<Pose2> walk() {
    return plan.walk();
  }

  /** The building of a floor plan that comes along. */
  public static World of(String plan) {
    return new World(FloorPlanReader.read(plan));
  }

  public static World demo() {
    return of("floorplan");
  }

  public List<Solid> solids() {
    return plan.solids();
  }

  /** The building's solids and those of its visitors. */
  public List<Solid> present() {
    return List.of(solids);
  }

  /** What has a name, visitors excepted. */
  public List<Thing> things() {
    return plan.things();
  }

  public List<Room> rooms() {
    return plan.rooms();
  }

  public Pose2 start() {
    return plan.start();
  }

  public Optional<Room> roomAt(double x, double y) {
    for (Room room : plan.rooms()) {
      if (room.contains(x, y)) {
        return Optional.of(room);
      }
    }
    return Optional.empty();
  }

  /**
   * Distance to the first thing a horizontal ray meets.
   *
   * @param height of the ray above the floor, metres
   * @param limit metres
   * @return metres; positive infinity if nothing is within the limit
   */
  public double range(double x, double y, double angle, double height, double limit) {
    RaySpan span = new RaySpan();
    double dx = Math.cos(angle);
    double dy = Math.sin(angle);
    double nearest = Double.POSITIVE_INFINITY;
    for (Solid solid : solids) {
      if (solid.covers(height) && solid.clip(x, y, dx, dy, span)) {
        nearest = Math.min(nearest, Math.max(0, span.enter));
      }
    }
    return nearest <= limit ? nearest : Double.POSITIVE_INFINITY;
  }

  /** Whether an upright cylinder standing on the floor has room at this place. */
  public boolean isFree(double x, double y, double radius, double height) {
    for (Solid solid : solids) {
      if (solid.bottom() < height && solid.isNear(x, y, radius) && solid.distance(x, y) < radius) {
        return false;
      }
    }
    return true;
  }
}
