package org.robotui.ros.action;

import java.util.Optional;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;

/** How a goal ended. */
public enum GoalEnd {

  /** The server reached it. */
  SUCCEEDED,
  /** The server gave it up. */
  ABORTED,
  /** The server did not want it. */
  REJECTED,
  /** It was cancelled, or replaced by another one, while the server worked on it. */
  PREEMPTED,
  /** It was cancelled before the server began with it. */
  RECALLED,
  /** What became of it is not known. */
  LOST;

  /** The end a server's status speaks of; empty for one that is no end. */
  static Optional<GoalEnd> of(int status) {
    return switch (status) {
      case GoalStatus.SUCCEEDED -> Optional.of(SUCCEEDED);
      case GoalStatus.ABORTED -> Optional.of(ABORTED);
      case GoalStatus.REJECTED -> Optional.of(REJECTED);
      case GoalStatus.PREEMPTED -> Optional.of(PREEMPTED);
      case GoalStatus.RECALLED -> Optional.of(RECALLED);
      case GoalStatus.LOST -> Optional.of(LOST);
      default -> Optional.empty();
    };
  }
}
