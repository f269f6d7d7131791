package org.robotui.message.data;

import java.util.List;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.NavigationStatus.State;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionFeedback;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionResult;

/** What {@code move_base} says of its goals, also of those that were not sent as goals of its action. */
final class NavigationAdapters {
  private NavigationAdapters() {}

  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.of(MoveBaseActionFeedback.class, NavigationStatus.class,
            (m, names) -> status(m.status()), m -> m.header().stamp()),
        Adapter.of(MoveBaseActionResult.class, NavigationStatus.class,
            (m, names) -> status(m.status()), m -> m.header().stamp()));
  }

  private static NavigationStatus status(GoalStatus status) {
    return new NavigationStatus(status.goalId().id(), state(status.status()), status.text());
  }

  private static State state(int status) {
    return switch (status) {
      case GoalStatus.SUCCEEDED -> State.SUCCEEDED;
      case GoalStatus.PREEMPTED, GoalStatus.RECALLED -> State.CANCELED;
      case GoalStatus.ABORTED, GoalStatus.LOST -> State.ABORTED;
      case GoalStatus.REJECTED -> State.REJECTED;
      default -> State.ACTIVE;
    };
  }
}
