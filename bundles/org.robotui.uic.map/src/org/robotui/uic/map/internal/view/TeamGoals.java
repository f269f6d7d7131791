package org.robotui.uic.map.internal.view;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.map.internal.MapPorts;

/**
 * Sends several robots to a place: each to a spot of its own around it, given in a frame of its own, through the
 * arbiter of its own; and tells one where it is. Never blocks.
 */
public final class TeamGoals {
  private static final Duration VALID = Duration.ofSeconds(2);
  private static final List<String> MAPS = List.of("map", "odom");
  private static final Words GOALS = new Words("goals", "goals", List.of("goal"));
  private static final Words POSES = new Words("poses", "initial_poses", List.of("initial_pose", "initialpose"));

  private final UicContext context;
  private final Output<NavigationGoal> goals;
  private final Output<PoseEstimate> poses;

  /** What is sent, the port of the map for it, and what robots usually call theirs. */
  private record Words(String what, String port, List<String> usual) {}

  /**
   * What became of it.
   *
   * @param told for users
   * @param spots where robots were sent, in the frame that was asked in
   */
  record Sent(CommandNotice told, Map<String, RigidTransform> spots) {}

  /** Sends through the ports of a map. */
  public TeamGoals(UicContext context) {
    this.context = context;
    this.goals = context.output(MapPorts.GOALS);
    this.poses = context.output(MapPorts.INITIAL_POSES);
  }

  /** The robots that can be sent somewhere. */
  Set<String> robots() {
    Set<String> robots = new LinkedHashSet<>();
    goals.targets().forEach(t -> authority(t).map(Authority::robot).ifPresent(robots::add));
    return robots;
  }

  /**
   * Sends robots to a place.
   *
   * @param robots who
   * @param fixed in which the place is given
   * @param pose the middle of their spots
   * @param gap between spots, metres
   */
  Sent send(Collection<String> robots, FrameId fixed, RigidTransform pose, double gap) {
    List<RigidTransform> spots = spots(robots.size(), pose, gap);
    Map<String, RigidTransform> sent = new LinkedHashMap<>();
    List<String> not = new ArrayList<>();
    int next = 0;
    for (String robot : robots) {
      RigidTransform spot = spots.get(next++);
      send(robot, fixed, spot).ifPresentOrElse(why -> not.add(robot + ": " + why), () -> sent.put(robot, spot));
    }
    String who = sent.size() == 1 ? sent.keySet().iterator().next() : sent.size() + " robots";
    String why = String.join("; ", not);
    CommandNotice told = not.isEmpty() ? new CommandNotice(Health.OK, "Goal sent to " + who)
        : new CommandNotice(Health.BAD,
            sent.isEmpty() ? "Not sent. " + why : "Goal sent to " + who + ", but not to " + why);
    return new Sent(told, sent);
  }

  /**
   * Tells a robot where it is.
   *
   * @param robot which one
   * @param fixed in which the place is given
   * @param pose where, and where it looks
   */
  CommandNotice place(String robot, FrameId fixed, RigidTransform pose) {
    return send(poses, robot, POSES, fixed, pose, Commander::roughly)
        .map(why -> new CommandNotice(Health.BAD, "Not sent. " + robot + ": " + why))
        .orElse(new CommandNotice(Health.OK, "Pose sent to " + robot));
  }

  private Optional<String> send(String robot, FrameId fixed, RigidTransform spot) {
    return send(goals, robot, GOALS, fixed, spot, NavigationGoal::new);
  }

  /** Why it was not sent, none where it was. */
  private <T extends Data> Optional<String> send(
      Output<T> output, String robot, Words words, FrameId fixed, RigidTransform spot,
      BiFunction<FrameId, RigidTransform, T> command) {
    List<SourceId> fitting = output.targets().stream()
        .filter(t -> authority(t).filter(a -> a.robot().equals(robot)).isPresent()).toList();
    List<SourceId> usual = fitting.stream()
        .filter(t -> words.usual().contains(t.port().substring(t.port().lastIndexOf('/') + 1))).toList();
    List<SourceId> one = fitting.size() == 1 ? fitting : usual;
    if (one.size() != 1) {
      return Optional.of(fitting.isEmpty() ? "it takes no " + words.what()
          : "it takes several kinds of " + words.what() + "; name one under 'connect', for example  map." + words.port()
              + ": " + fitting.getFirst());
    }
    Optional<T> own = own(robot, fixed, spot, command);
    if (own.isEmpty()) {
      return Optional.of("where it is relative to " + fixed + " is not known; write it under 'frames'");
    }
    Authority authority = authority(one.getFirst()).orElseThrow();
    if (authority.take(context.principal(), false) instanceof LeaseOutcome.HeldBy held) {
      return Optional.of(held.holder().label() + " controls it");
    }
    return output.send(one.getFirst(), own.get(), VALID) instanceof CommandOutcome.Refused r
        ? Optional.of(r.explanation())
        : Optional.empty();
  }

  /** The command in a frame of the robot: that of the same name, else its map, else where its odometry began. */
  private <T> Optional<T> own(String robot, FrameId fixed, RigidTransform spot,
      BiFunction<FrameId, RigidTransform, T> command) {
    if (fixed.robot().equals(robot)) {
      return Optional.of(command.apply(fixed, spot));
    }
    Set<FrameId> known = Set.copyOf(context.frames().all());
    return Stream.concat(Stream.of(fixed.name()), MAPS.stream()).distinct().map(name -> new FrameId(robot, name))
        .filter(known::contains)
        .flatMap(frame -> context.frames().lookup(frame, fixed, Optional.empty()).transform()
            .map(t -> command.apply(frame, t.times(spot))).stream())
        .findFirst();
  }

  private Optional<Authority> authority(SourceId target) {
    return context.ruic().authority(target.component());
  }

  /** Spots in rows around a place, as many as wanted, all with the same heading. */
  static List<RigidTransform> spots(int count, RigidTransform pose, double gap) {
    int side = (int) Math.ceil(Math.sqrt(count));
    int rows = side == 0 ? 0 : (count + side - 1) / side;
    List<RigidTransform> spots = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      int inRow = Math.min(side, count - i / side * side);
      double x = ((rows - 1) / 2.0 - i / side) * gap;
      double y = ((inRow - 1) / 2.0 - i % side) * gap;
      spots.add(new RigidTransform(pose.apply(new Vector3(x, y, 0)), pose.rotation()));
    }
    return spots;
  }
}
