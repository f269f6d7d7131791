package org.robotui.sim.internal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.sim.internal.Event.Severity;
import org.robotui.sim.internal.GoalStatus.Phase;
import org.robotui.sim.internal.nav.Homing;
import org.robotui.sim.internal.nav.Navigator;
import org.robotui.sim.internal.nav.Plan;
import org.robotui.sim.internal.nav.Progress;
import org.robotui.sim.internal.robot.CommandGate;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/** Decides how fast the robot should go: as somebody commands it, else towards its goal. For one thread. */
final class Pilot {
  private final CommandGate gate = new CommandGate();
  private final Navigator navigator;
  private final Consumer<Event> events;
  private Speed navigation = Speed.ZERO;
  private Optional<Homing> homing = Optional.empty();
  private GoalStatus status = GoalStatus.NONE;

  Pilot(Navigator navigator, Consumer<Event> events) {
    this.navigator = navigator;
    this.events = events;
  }

  Speed wish() {
    return gate.isLive() ? gate.command() : navigation;
  }

  GoalStatus status() {
    return status;
  }

  Optional<Pose2> goal() {
    return navigator.goal();
  }

  List<Pose2> path() {
    return navigator.path();
  }

  /** Takes a command, which ends navigation. */
  void drive(Speed speed, double until) {
    preempt("goal cancelled by a command to drive");
    gate.accept(speed, until);
  }

  /** Takes a place of odometry to drive to, which ends navigation. */
  void approach(Pose2 pose, Speed most) {
    preempt("goal cancelled by a command to drive");
    gate.clear();
    homing = Optional.of(new Homing(pose, most));
  }

  void expire(double now) {
    if (gate.expire(now)) {
      report(Severity.WARN, "base", "the command to drive timed out: stopped");
    }
  }

  void stop(String text) {
    preempt("goal cancelled");
    gate.clear();
    report(Severity.INFO, "base", text);
  }

  /** Gives up a goal, unless it is not the present one. */
  void cancel(String id) {
    if (status.id().equals(id)) {
      preempt("goal cancelled");
    }
  }

  void cruise(Speed cruise) {
    navigator.cruise(cruise);
  }

  /** Gives up whatever it is doing, because something is in the way. */
  void blocked(String reason) {
    homing = Optional.empty();
    gate.clear();
    if (navigator.goal().isPresent()) {
      navigator.cancel();
      end(Phase.ABORTED, Severity.WARN, "goal aborted: " + reason);
    }
  }

  private void preempt(String text) {
    homing = Optional.empty();
    navigation = Speed.ZERO;
    if (navigator.goal().isPresent()) {
      navigator.cancel();
      end(Phase.PREEMPTED, Severity.INFO, text);
    }
  }

  /** Takes a goal in place of the one before. */
  void goTo(String id, Pose2 goal, Pose2 estimate) {
    preempt("goal replaced");
    gate.clear();
    status = new GoalStatus(status.number() + 1, id, Phase.ACTIVE, "on the way");
    switch (navigator.start(goal, estimate)) {
      case Plan.Found found -> report(Severity.INFO, "navigation",
          String.format(Locale.ROOT, "goal accepted: %.2f, %.2f", goal.x(), goal.y()));
      case Plan.Impossible impossible -> end(
          Phase.REJECTED, Severity.WARN, "goal refused: " + impossible.reason());
    }
  }

  /** Goes on with the goal, if there is one, from where localisation believes to be now. */
  void relocalised(Pose2 estimate) {
    navigator.goal().ifPresent(goal -> goTo(status.id(), goal, estimate));
  }

  /**
   * Goes on for {@code dt} seconds.
   *
   * @param odometry where the wheels say it is
   * @param room free distance before the robot, metres
   */
  void navigate(Pose2 estimate, Pose2 odometry, double room, double dt) {
    if (homing.isPresent()) {
      approach(homing.get(), odometry);
      return;
    }
    switch (navigator.update(estimate, room, dt)) {
      case Progress.Driving driving -> navigation = driving.speed();
      case Progress.Idle idle -> navigation = Speed.ZERO;
      case Progress.Reached reached -> end(Phase.SUCCEEDED, Severity.INFO, "goal reached");
      case Progress.Aborted aborted -> end(
          Phase.ABORTED, Severity.WARN, "goal aborted: " + aborted.reason());
    }
  }

  private void approach(Homing there, Pose2 odometry) {
    Optional<Speed> speed = there.update(odometry);
    navigation = speed.orElse(Speed.ZERO);
    if (speed.isEmpty()) {
      homing = Optional.empty();
    }
  }

  private void end(Phase phase, Severity severity, String text) {
    navigation = Speed.ZERO;
    status = new GoalStatus(status.number(), status.id(), phase, text);
    report(severity, "navigation", text);
  }

  private void report(Severity severity, String source, String text) {
    events.accept(new Event(severity, source, text));
  }
}
