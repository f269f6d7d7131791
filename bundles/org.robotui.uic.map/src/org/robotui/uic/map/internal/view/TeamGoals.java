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
import java.util.stream.Stream;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.NavigationGoal;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Health;
import org.robotui.ui.scene.Told;
import org.robotui.uic.map.internal.MapPorts;

/**
 * Sends several robots to a place: each to a spot of its own around it, given in a frame of its own, through the arbiter of its own. Never blocks.
 */
public final class TeamGoals {
  private static final Duration VALID = Duration.ofSeconds(2);
  private static final List<String> MAPS = List.of("map", "odom");
  private static final String USUAL = "goal";

  private final UicContext context;
  private final Output<NavigationGoal> goals;

  /**
   * What became of it.
   *
   * @param told for users
   * @param spots where robots were sent, in the frame that was asked in
   */
  record Sent(Told told, Map<String, RigidTransform> spots) {}

  /** Sends through the ports of a map. */
  public TeamGoals(UicContext context) {
    this.context = context;
    this.goals = context.output(MapPorts.GOALS);
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
    Told told = not.isEmpty() ? new Told(Health.OK, "Goal sent to " + who)
        : new Told(Health.BAD, sent.isEmpty() ? "Not sent. " + why : "Goal sent to " + who + ", but not to " + why);
    return new Sent(told, sent);
  }

  /** Why it was not sent, none where it was. */
  private Optional<String> send(String robot, FrameId fixed, RigidTransform spot) {
    List<SourceId> fitting = goals.targets().stream()
        .filter(t -> authority(t).filter(a -> a.robot().equals(robot)).isPresent()).toList();
    List<SourceId> usual = fitting.stream().filter(t -> t.port().substring(t.port().lastIndexOf('/') + 1).equals(USUAL)).toList();
    List<SourceId> one = fitting.size() == 1 ? fitting : usual;
    if (one.size() != 1) {
      return Optional.of(fitting.isEmpty() ? "it takes no goals" : "it takes several kinds of goals; name one under 'connect', for example  map.goals: "
          + fitting.getFirst());
    }
    Optional<NavigationGoal> goal = own(robot, fixed, spot);
    if (goal.isEmpty()) {
      return Optional.of("where it is relative to " + fixed + " is not known; write it under 'frames'");
    }
    Authority authority = authority(one.getFirst()).orElseThrow();
    if (authority.take(context.principal(), false) instanceof LeaseOutcome.HeldBy held) {
      return Optional.of(held.holder().label() + " drives it");
    }
    return goals.send(one.getFirst(), goal.get(), VALID) instanceof CommandOutcome.Refused r
        ? Optional.of(r.explanation()) : Optional.empty();
  }

  /** The goal in a frame of the robot: that of the same name, else its map, else where its odometry began. */
  private Optional<NavigationGoal> own(String robot, FrameId fixed, RigidTransform spot) {
    if (fixed.robot().equals(robot)) {
      return Optional.of(new NavigationGoal(fixed, spot));
    }
    Set<FrameId> known = Set.copyOf(context.frames().all());
    return Stream.concat(Stream.of(fixed.name()), MAPS.stream()).distinct().map(name -> new FrameId(robot, name)).filter(known::contains)
        .flatMap(frame -> context.frames().lookup(frame, fixed, Optional.empty()).transform()
            .map(t -> new NavigationGoal(frame, t.times(spot))).stream())
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
