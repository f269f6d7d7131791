package org.robotui.sim.internal.player;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.robotui.player.interfaces.Planner;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.layout.Empty;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.GoalStatus;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.world.Pose2;

/** {@code planner:0}. It stops when it is disabled, or when the last client goes. */
final class Planning implements Part {
  private static final Rate RATE = new Rate(5);
  /** Stock clients have no room for more. */
  private static final int MOST_WAYPOINTS = 128;
  private static final String NAME = "player-";

  private final Bench bench;
  private final ServedDevice device;
  private final AtomicBoolean enabled = new AtomicBoolean(true);
  private final AtomicLong goals = new AtomicLong();

  Planning(Bench bench) {
    this.bench = bench;
    device = bench.add("planner", 0, bench.handler(this::clients)
        .on(Planner.GOAL, goal -> go(goal.pose()))
        .on(Planner.GET_WAYPOINTS, none -> Optional.of(waypoints(bench.state())))
        .on(Planner.ENABLE, enable -> enable(enable.on())));
  }

  private void clients(int clients) {
    if (clients == 0) {
      cancel();
    }
  }

  private void go(Pose2d goal) {
    if (enabled.get() && Poses.isFinite(goal)) {
      bench.submit(new Command.Goal(NAME + goals.incrementAndGet(), Poses.planar(goal)));
    }
  }

  private Optional<Empty> enable(boolean on) {
    enabled.set(on);
    if (!on) {
      cancel();
    }
    return Optional.of(new Empty());
  }

  /** Gives up the last goal of this planner, if it is under way. */
  private void cancel() {
    bench.submit(new Command.Cancel(NAME + goals.get()));
  }

  private static Planner.Waypoints waypoints(RobotState state) {
    List<Pose2> way = state.path();
    double length = IntStream.range(1, way.size()).mapToDouble(i -> way.get(i).distanceTo(way.get(i - 1))).sum();
    return new Planner.Waypoints(length, thinned(way).stream().map(Poses::of).toList());
  }

  /** The way with its start and its end, and no more poses between than there is room for. */
  private static List<Pose2> thinned(List<Pose2> way) {
    if (way.size() <= MOST_WAYPOINTS) {
      return way;
    }
    return IntStream.range(0, MOST_WAYPOINTS)
        .mapToObj(i -> way.get((int) ((long) i * (way.size() - 1) / (MOST_WAYPOINTS - 1)))).toList();
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (RATE.isDue(step) && device.clients() > 0) {
      device.publish(Planner.STATE, state(state), stamp);
    }
  }

  private static Planner.State state(RobotState state) {
    List<Pose2> way = thinned(state.path());
    Pose2 here = state.estimate();
    int next = Math.min(nearest(way, here) + 1, way.size() - 1);
    Pose2 goal = state.goal().orElse(here);
    boolean done = state.goal().isEmpty() && state.goalStatus().number() > 0
        && state.goalStatus().phase() == GoalStatus.Phase.SUCCEEDED;
    return new Planner.State(!way.isEmpty(), done, Poses.of(here), Poses.of(goal),
        Poses.of(next < 0 ? here : way.get(next)), next, way.size());
  }

  private static int nearest(List<Pose2> way, Pose2 here) {
    int nearest = -1;
    for (int i = 0; i < way.size(); i++) {
      if (nearest < 0 || way.get(i).distanceTo(here) < way.get(nearest).distanceTo(here)) {
        nearest = i;
      }
    }
    return nearest;
  }
}
