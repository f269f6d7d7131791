package org.robotui.rfic.xbot.internal.follow;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.xbot.Board;

/**
 * The actions of a control: each plugin of type {@code JointTrajectory} follows trajectories. A goal begins at its
 * stamp, is checked by the plugin, and takes over from the one before. Safe for all threads.
 */
public final class FollowActions implements CallHandler<ActionRequest, ActionReply> {
  /** The type of all of them. */
  public static final String TYPE = "control_msgs/FollowJointTrajectory";

  private static final String PLUGIN_TYPE = "JointTrajectory";
  private static final String NAME = "/follow_joint_trajectory";
  private static final long MILLI = 1_000_000L;

  private final FollowLink link;
  private final AtomicLong tags = new AtomicLong();

  /**
   * With a control.
   *
   * @param link to it
   */
  public FollowActions(FollowLink link) {
    this.link = link;
  }

  /** The names of the actions. */
  public List<String> names() {
    return link.plugins().stream().filter(plugin -> plugin.type().equals(PLUGIN_TYPE)).map(FollowActions::name)
        .sorted().toList();
  }

  private static String name(Board.Plugin plugin) {
    return plugin.name() + NAME;
  }

  @Override
  public ActionReply handle(Invocation<ActionRequest> invocation) throws CallException {
    String action = invocation.request().action();
    Board.Plugin plugin = link.plugins().stream().filter(each -> each.type().equals(PLUGIN_TYPE))
        .filter(each -> name(each).equals(action.replaceFirst("^/", ""))).findFirst()
        .orElseThrow(() -> new CallException("there is no action " + action + "; there are " + names()));
    FollowGoal goal = goal(invocation.request());
    List<String> robot = link.joints();
    Optional<ActionReply> objection = goal.objection(robot, now());
    if (objection.isPresent()) {
      return objection.get();
    }
    if (plugin.state() != Board.PluginState.RUNNING) {
      return FollowCode.INVALID_GOAL.rejected(plugin.name() + " does not run: start it first");
    }
    if (!reached(goal)) {
      return FollowCode.SUCCESSFUL.end(ActionReply.End.RECALLED, "cancelled before it began");
    }
    long tag = tag();
    return new FollowedGoal(link, plugin.name(), tag, FollowFeedback.of(goal.joints(), robot), invocation)
        .follow(goal.orders(tag, now()));
  }

  private static FollowGoal goal(ActionRequest request) throws CallException {
    try {
      return FollowGoal.of(request.goal());
    } catch (IllegalArgumentException e) {
      throw new CallException("this is no goal of " + TYPE + ": " + e.getMessage(), e);
    }
  }

  /** Waits for the beginning of a goal; false where it is cancelled meanwhile. */
  private static boolean reached(FollowGoal goal) {
    try {
      for (long left = goal.delayNanos(now()); left > 0; left = goal.delayNanos(now())) {
        Thread.sleep(left / MILLI, (int) (left % MILLI));
      }
      return true;
    } catch (InterruptedException e) {
      return false;
    }
  }

  /** The clock of the machine tells clients apart, and one that was started anew from what it was before. */
  private long tag() {
    return tags.accumulateAndGet(System.nanoTime() & Long.MAX_VALUE, (before, time) -> Math.max(before + 1, time));
  }

  private static long now() {
    return System.currentTimeMillis() * MILLI;
  }
}
