package org.robotui.ros2.action;

/** How a goal ended. */
public enum Ros2GoalEnd {

  /** The server reached it. */
  SUCCEEDED,
  /** The server gave it up. */
  ABORTED,
  /** It was cancelled. */
  CANCELED,
  /** The server did not want it. */
  REJECTED,
  /** What became of it is not known. */
  LOST
}
