package org.robotui.sim.internal.world;

import java.util.List;

/**
 * What a plan file says.
 *
 * @param rooms in the order of the file; together they cover the building
 * @param solids walls and furniture
 * @param things that have names; they are among the solids
 * @param walk corners of the way that somebody walks round and round; empty if nobody does
 * @param start where the robot starts, and where its charger is
 */
public record FloorPlan(List<Room> rooms, List<Solid> solids, List<Thing> things, List<Pose2> walk, Pose2 start) {
  public FloorPlan {
    rooms = List.copyOf(rooms);
    solids = List.copyOf(solids);
    things = List.copyOf(things);
    walk = List.copyOf(walk);
    if (rooms.isEmpty()) {
      throw new IllegalArgumentException("a floor plan needs at least one room");
    }
  }
}
