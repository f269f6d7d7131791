package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Grippers with two fingers. The interface {@code gripper}. */
public final class Gripper {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("gripper", "state", State.class);

  /** Request: get geometry; answered by {@link Geometry}. */
  public static final Kind.Request<Empty, Geometry> GET_GEOMETRY =
      new Kind.Request<>("gripper", "get_geometry", Empty.class, Geometry.class);

  /** Command: open. */
  public static final Kind.Command<Empty> OPEN = new Kind.Command<>("gripper", "open", Empty.class);

  /** Command: close. */
  public static final Kind.Command<Empty> CLOSE = new Kind.Command<>("gripper", "close", Empty.class);

  /** Command: stop. */
  public static final Kind.Command<Empty> STOP = new Kind.Command<>("gripper", "stop", Empty.class);

  /** Command: store. */
  public static final Kind.Command<Empty> STORE = new Kind.Command<>("gripper", "store", Empty.class);

  /** Command: retrieve. */
  public static final Kind.Command<Empty> RETRIEVE = new Kind.Command<>("gripper", "retrieve", Empty.class);

  private Gripper() {}

  /**
   * What the gripper does and holds.
   *
   * @param state 1 open, 2 closed, 3 moving, 4 failed
   * @param beams a bit for each light beam that is broken
   * @param stored how many things are in the store
   */
  public record State(int state, long beams, int stored) {}

  /**
   * Where and how large it is.
   *
   * @param pose on the robot
   * @param outer of the whole
   * @param inner between the open fingers
   * @param beams how many light beams there are
   * @param capacity how many things the store takes, 0 for no store
   */
  public record Geometry(Pose3d pose, Size3d outer, Size3d inner, int beams, int capacity) {}
}
