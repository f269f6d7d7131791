package org.robotui.sim.internal.ros;

import java.util.function.Consumer;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionFeedback;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionGoal;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionResult;
import org.robotui.message.ros.move_base_msgs.MoveBaseFeedback;
import org.robotui.message.ros.move_base_msgs.MoveBaseResult;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Event;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.message.Frames;
import org.robotui.sim.internal.message.Places;
import org.robotui.sim.internal.message.Poses;
import org.robotui.sim.internal.message.RobotClock;
import org.robotui.sim.internal.message.Stamp;
import org.robotui.sim.internal.message.Topic;
import org.robotui.sim.internal.message.TopicKind;

/**
 * Serves the action {@code move_base}, and takes simple goals as goals of it. Locked, as goals come on threads of their
 * links.
 */
final class MoveBase {
  private final Simulation simulation;
  private final Places places;
  private final RobotClock clock;
  private final Consumer<Event> events;
  private final String name;
  private final DriveGoals goals = new DriveGoals();
  private final Topic<GoalStatusArray> status;
  private final Topic<MoveBaseActionFeedback> feedback;
  private final Topic<MoveBaseActionResult> result;
  private long simpleGoals;

  MoveBase(RosMessageNode node, Simulation simulation, Places places, RobotClock clock, Consumer<Event> events) {
    this.simulation = simulation;
    this.places = places;
    this.clock = clock;
    this.events = events;
    name = node.resolved("move_base");
    status = Topic.of(node, "move_base/status", GoalStatusArray.class, TopicKind.STATE);
    feedback = Topic.of(node, "move_base/feedback", MoveBaseActionFeedback.class, TopicKind.STATE);
    result = Topic.of(node, "move_base/result", MoveBaseActionResult.class, TopicKind.STATE);
    node.listen("move_base/goal", MoveBaseActionGoal.class, goal -> take(named(goal), goal.goal().targetPose()));
    node.listen("move_base/cancel", GoalID.class, this::cancel);
    node.listen("move_base_simple/goal", PoseStamped.class, this::drive);
  }

  /** Drives to a place, as with a simple goal. */
  void drive(PoseStamped target) {
    take(simple(), target);
  }

  /** A goal without a name gets one, as with actionlib's servers. */
  private GoalID named(MoveBaseActionGoal goal) {
    GoalID id = goal.goalId();
    return id.id().isEmpty() ? new GoalID(id.stamp() == 0 ? clock.nanos() : id.stamp(), simple().id()) : id;
  }

  private synchronized GoalID simple() {
    simpleGoals++;
    return new GoalID(clock.nanos(), name + "-" + simpleGoals + "-" + clock.nanos());
  }

  private synchronized void take(GoalID id, PoseStamped target) {
    goals.add(id, clock.nanos()).ifPresent(goal -> {
      if (goal.isOver()) {
        publishResult(goal);
        return;
      }
      Places.Found place = places.inMap(target.header().frameId(), target.pose());
      String problem = place.pose().isEmpty() ? place.problem()
          : simulation.submit(new Command.Goal(id.id(), place.pose().get())) ? "" : "too many commands at once";
      if (!problem.isEmpty()) {
        events.accept(new Event(Event.Severity.WARN, "commands", "goal refused: " + problem));
        publishResult(goals.refuse(goal, "goal refused: " + problem, clock.nanos()));
      }
      publishStatus(clock.nanos());
    });
  }

  private synchronized void cancel(GoalID wish) {
    goals.cancel(wish, clock.nanos()).forEach(id -> simulation.submit(new Command.Cancel(id)));
    publishStatus(clock.nanos());
  }

  /** Follows the robot by one step. */
  synchronized void publish(long step, RobotState state, long nanos) {
    goals.follow(state.goalStatus(), nanos).forEach(this::publishResult);
    if (Rate.GOALS.isDue(step)) {
      publishStatus(nanos);
      goals.active().ifPresent(goal -> feedback.publish(nanos, stamp -> feedback(goal, state, stamp)));
    }
  }

  private static MoveBaseActionFeedback feedback(DriveGoal goal, RobotState state, Stamp stamp) {
    PoseStamped place = new PoseStamped(stamp.header(Frames.MAP), Poses.pose(state.estimate()));
    return new MoveBaseActionFeedback(stamp.header(""), goal.message(), new MoveBaseFeedback(place));
  }

  private void publishResult(DriveGoal goal) {
    result.publish(clock.nanos(),
        stamp -> new MoveBaseActionResult(stamp.header(""), goal.message(), new MoveBaseResult()));
    publishStatus(clock.nanos());
  }

  private void publishStatus(long nanos) {
    status.publish(nanos, stamp -> new GoalStatusArray(stamp.header(""), goals.messages()));
  }
}
