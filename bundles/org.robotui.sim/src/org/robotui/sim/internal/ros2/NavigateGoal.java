package org.robotui.sim.internal.ros2;

import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalWorker;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.GoalStatus;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.message.RobotClock;
import org.robotui.sim.internal.world.Pose2;

/** One goal on its way. For the thread that works on it, but for {@link #begun}. */
final class NavigateGoal {
  private final String id;
  private final Pose2 target;
  private final Ros2GoalWorker.Running running;
  private final RobotClock clock;
  private final long since;
  private volatile boolean begun;
  private boolean cancelling;

  NavigateGoal(String id, Pose2 target, Ros2GoalWorker.Running running, RobotClock clock) {
    this.id = id;
    this.target = target;
    this.running = running;
    this.clock = clock;
    since = clock.nanos();
  }

  Command command() {
    return new Command.Goal(id, target);
  }

  /** From now on the robot's state shows this goal, or a newer one. */
  void begun() {
    begun = true;
  }

  /**
   * Follows the robot, tells how far it got, and takes a wish to cancel to it.
   *
   * @param state read after the last call of this
   * @param commands takes commands
   * @return how the goal ended; empty while it did not
   */
  Optional<Ros2GoalWorker.End> follow(RobotState state, Consumer<Command> commands) {
    if (!begun) {
      return Optional.empty();
    }
    GoalStatus status = state.goalStatus();
    if (!status.id().equals(id)) {
      return Optional.of(NavigateMessages.aborted("goal replaced"));
    }
    if (status.phase() != GoalStatus.Phase.ACTIVE) {
      return Optional.of(end(status));
    }
    if (running.cancelled() && !cancelling) {
      cancelling = true;
      commands.accept(new Command.Cancel(id));
    }
    running.feedback(NavigateMessages.feedback(state, clock.nanos(), clock.nanos() - since));
    return Optional.empty();
  }

  /** What is cancelled by others, as by a stop, is aborted: a goal of ROS 2 is cancelled only if its client asked. */
  private Ros2GoalWorker.End end(GoalStatus status) {
    return switch (status.phase()) {
      case SUCCEEDED -> NavigateMessages.ended(Ros2GoalEnd.SUCCEEDED);
      case PREEMPTED -> running.cancelled() ? NavigateMessages.ended(Ros2GoalEnd.CANCELED)
          : NavigateMessages.aborted(status.text());
      default -> NavigateMessages.aborted(status.text());
    };
  }
}
