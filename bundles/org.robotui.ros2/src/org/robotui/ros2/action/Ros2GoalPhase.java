package org.robotui.ros2.action;

/** How far a goal got. */
public enum Ros2GoalPhase {

  /** The goal was sent, and the server did not say yet whether it takes it. */
  WAITING_FOR_ACCEPTANCE,
  /** The server took the goal and did not begin with it. */
  ACCEPTED,
  /** The server works on it. */
  EXECUTING,
  /** The server ends its work on the goal, as it was asked to. */
  CANCELING,
  /** The goal ended. */
  DONE
}
