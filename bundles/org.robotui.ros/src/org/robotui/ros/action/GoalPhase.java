package org.robotui.ros.action;

/** How far a goal got, as actionlib's clients tell it. */
public enum GoalPhase {

  /** The goal was sent, and the server did not mention it yet. */
  WAITING_FOR_ACKNOWLEDGEMENT,
  /** The server has the goal and did not begin with it. */
  PENDING,
  /** The server works on it. */
  ACTIVE,
  /** A cancellation was sent, and the server did not mention it yet. */
  WAITING_FOR_CANCEL,
  /** The server takes the goal back before it began with it. */
  RECALLING,
  /** The server ends its work on the goal. */
  PREEMPTING,
  /** The server says that the goal ended, and its result did not come yet. */
  WAITING_FOR_RESULT,
  /** The goal ended. */
  DONE
}
