package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Planners of ways in the plane. The interface {@code planner}. */
public final class Planner {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("planner", "state", State.class);

  /** Command: goal. */
  public static final Kind.Command<Place> GOAL = new Kind.Command<>("planner", "goal", Place.class);

  /** Command: start. */
  public static final Kind.Command<Place> START = new Kind.Command<>("planner", "start", Place.class);

  /** Request: get waypoints; answered by {@link Waypoints}. */
  public static final Kind.Request<Empty, Waypoints> GET_WAYPOINTS =
      new Kind.Request<>("planner", "get_waypoints", Empty.class, Waypoints.class);

  /** Request: enable by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> ENABLE =
      new Kind.Request<>("planner", "enable", Switch.class, Empty.class);

  private Planner() {}

  /**
   * How far it is.
   *
   * @param valid whether there is a way
   * @param done whether the goal is reached
   * @param position where the robot is
   * @param goal where it goes
   * @param waypoint where it goes next
   * @param index the number of that waypoint, negative for none
   * @param waypoints how many there are
   */
  public record State(boolean valid, boolean done, Pose2d position, Pose2d goal, Pose2d waypoint, int index,
      long waypoints) {}

  /**
   * A goal or a start.
   *
   * @param pose on the map
   */
  public record Place(Pose2d pose) {}

  /**
   * The whole way.
   *
   * @param distance along it, metres
   * @param waypoints from the start to the goal
   */
  public record Waypoints(double distance, List<Pose2d> waypoints) {}
}
