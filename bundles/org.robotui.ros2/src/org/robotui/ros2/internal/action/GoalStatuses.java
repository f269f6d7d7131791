package org.robotui.ros2.internal.action;

import java.util.Optional;
import org.robotui.ros2.action.Ros2GoalEnd;

/** The numbers of {@code action_msgs/msg/GoalStatus}. */
final class GoalStatuses {

  /** The client does not know yet whether it is accepted. */
  static final int UNDECIDED = 0;
  static final int ACCEPTED = 1;
  static final int EXECUTING = 2;
  static final int CANCELING = 3;
  static final int SUCCEEDED = 4;
  static final int CANCELED = 5;
  static final int ABORTED = 6;

  private GoalStatuses() {}

  /** The end that a status speaks of; empty for one that is no end. */
  static Optional<Ros2GoalEnd> end(int status) {
    return switch (status) {
      case SUCCEEDED -> Optional.of(Ros2GoalEnd.SUCCEEDED);
      case CANCELED -> Optional.of(Ros2GoalEnd.CANCELED);
      case ABORTED -> Optional.of(Ros2GoalEnd.ABORTED);
      default -> Optional.empty();
    };
  }

  static int of(Ros2GoalEnd end) {
    return switch (end) {
      case SUCCEEDED -> SUCCEEDED;
      case CANCELED -> CANCELED;
      case ABORTED, REJECTED, LOST -> ABORTED;
    };
  }
}
