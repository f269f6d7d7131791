package org.robotui.rfic.xbot.internal.follow;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.input.Numerals;
import org.robotui.api.port.ActionReply;
import org.robotui.data.control.PluginPhrases;

/**
 * A goal of control_msgs/FollowJointTrajectory, of ROS 1 or ROS 2.
 *
 * @param stampNanos when it is to begin, since the epoch; 0 is at once
 * @param joints in the order of the values
 * @param points by time
 * @param path how far joints may be from the way
 * @param goal how far they may be from the last point
 * @param patienceSeconds within which they have to come there; 0 is what the plugin says
 * @param foreign whether it has what no joint follows: several degrees of freedom at once
 */
record FollowGoal(long stampNanos, List<String> joints, List<Point> points, List<Tolerance> path,
    List<Tolerance> goal, double patienceSeconds, boolean foreign) {
  private static final double SECOND = 1e9;

  /**
   * A point.
   *
   * @param positions rad or m
   * @param velocities per second, may be empty
   * @param accelerations per second squared, may be empty
   * @param nanos since the beginning
   */
  record Point(List<String> positions, List<String> velocities, List<String> accelerations, long nanos) {}

  /**
   * How far a joint may be away.
   *
   * @param joint its name
   * @param position rad or m: 0 is what the plugin says, below it any
   * @param moving whether velocities or accelerations are to be watched
   */
  record Tolerance(String joint, double position, boolean moving) {}

  /**
   * Reads a goal.
   *
   * @throws IllegalArgumentException where a field holds something else than it should
   */
  static FollowGoal of(Map<String, Object> fields) {
    GoalFields goal = new GoalFields(fields);
    GoalFields way = goal.inner("trajectory");
    boolean foreign = !goal.inner("multi_dof_trajectory").texts("joint_names").isEmpty()
        || !goal.list("component_path_tolerance").isEmpty() || !goal.list("component_goal_tolerance").isEmpty();
    return new FollowGoal(way.inner("header").nanos("stamp"), way.texts("joint_names"),
        way.list("points").stream()
            .map(p -> new Point(p.numbers("positions"), p.numbers("velocities"), p.numbers("accelerations"),
                p.nanos("time_from_start")))
            .toList(),
        tolerances(goal, "path_tolerance"), tolerances(goal, "goal_tolerance"),
        goal.nanos("goal_time_tolerance") / SECOND, foreign);
  }

  private static List<Tolerance> tolerances(GoalFields goal, String name) {
    return goal.list(name).stream().map(each -> new Tolerance(each.text("name"), each.number("position"),
        each.number("velocity") > 0 || each.number("acceleration") > 0)).toList();
  }

  /** What speaks against it before any plugin is asked; the plugin checks all else. */
  Optional<ActionReply> objection(List<String> known, long nowNanos) {
    Optional<String> unknown = joints.stream().filter(name -> !known.contains(name)).findFirst();
    if (joints.isEmpty()) {
      return Optional.of(FollowCode.INVALID_JOINTS.rejected("no joint is named"));
    }
    if (unknown.isPresent()) {
      return Optional.of(FollowCode.INVALID_JOINTS.rejected("'" + unknown.get() + "' is no joint of this robot"));
    }
    return fault().map(FollowCode.INVALID_GOAL::rejected).or(() -> isOver(nowNanos)
        ? Optional.of(FollowCode.OLD_HEADER_TIMESTAMP.rejected(String.format(Locale.ROOT,
            "its last point was to be reached %.3f s ago", (passed(nowNanos) - points.getLast().nanos()) / SECOND)))
        : Optional.empty());
  }

  private Optional<String> fault() {
    if (points.isEmpty()) {
      return Optional.of("there is no point");
    }
    if (foreign) {
      return Optional.of("only single joints are moved: nothing follows a trajectory of several degrees of freedom");
    }
    return Stream.concat(path.stream(), goal.stream()).flatMap(each -> fault(each).stream()).findFirst();
  }

  private Optional<String> fault(Tolerance each) {
    if (!joints.contains(each.joint())) {
      return Optional.of("a tolerance is given of '" + each.joint() + "', which is no joint of this trajectory");
    }
    return each.moving()
        ? Optional.of("a tolerance of the velocity or acceleration of " + each.joint()
            + " is given: only that of its position is watched")
        : Optional.empty();
  }

  /** How long ago it began; 0 where it is still to begin. */
  private long passed(long nowNanos) {
    return stampNanos == 0 ? 0 : Math.max(0, nowNanos - stampNanos);
  }

  private boolean isOver(long nowNanos) {
    return passed(nowNanos) > 0 && points.getLast().nanos() <= passed(nowNanos);
  }

  /** How long it waits for its beginning. */
  long delayNanos(long nowNanos) {
    return stampNanos == 0 ? 0 : Math.max(0, stampNanos - nowNanos);
  }

  /** What the plugin is told; points whose time has passed are left out. */
  List<String> orders(long tag, long nowNanos) {
    long passed = passed(nowNanos);
    PluginPhrases said = new PluginPhrases(tag).say("begin").list("joints", joints);
    points.stream().filter(point -> passed == 0 || point.nanos() > passed).forEach(point -> {
      said.say("point " + Numerals.text((point.nanos() - passed) / SECOND)).list("positions", point.positions());
      values(said, "velocities", point.velocities());
      values(said, "accelerations", point.accelerations());
    });
    allow(said, "path", path);
    allow(said, "goal", goal);
    if (patienceSeconds != 0) {
      said.say("patience " + Numerals.text(Math.max(0, patienceSeconds)));
    }
    return said.say("run").orders();
  }

  private static void values(PluginPhrases said, String verb, List<String> numbers) {
    if (!numbers.isEmpty()) {
      said.list(verb, numbers);
    }
  }

  private static void allow(PluginPhrases said, String verb, List<Tolerance> tolerances) {
    tolerances.stream().filter(each -> each.position() != 0)
        .forEach(each -> said.say(verb + " " + Numerals.text(Math.max(0, each.position())) + " " + each.joint()));
  }
}
