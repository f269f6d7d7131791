package org.robotui.uic.scene3d.internal.waypoint;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.port.InputState;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Commander;

/**
 * Drives a robot from waypoint to waypoint: the next goal is given when the robot has come near the last one. Whatever
 * takes the robot out of the user's hands ends it: the stop, a lost lease, a refused goal, a robot that stands still
 * for long. It ends for good: nothing drives on by itself afterwards. Asked for from any thread, driven by the worker.
 */
public final class Tour {
  private static final double NEAR_RADIANS = Math.toRadians(30);
  private static final double STEP_METRES = 0.05;
  private static final long PATIENCE_NANOS = 30_000_000_000L;

  private final Commander commander;
  private final Output<NavigationGoal> goals;
  private final Principal principal;
  private final Consumer<CommandNotice> tell;
  private final AtomicReference<Optional<Wish>> wish = new AtomicReference<>(Optional.empty());
  private volatile Optional<Leg> leg = Optional.empty();

  /** Drives by a commander, and tells what becomes of it. */
  public Tour(Commander commander, Output<NavigationGoal> goals, Principal principal, Consumer<CommandNotice> tell) {
    this.commander = commander;
    this.goals = goals;
    this.principal = principal;
    this.tell = tell;
  }

  /** What a user asked for: to begin at a waypoint, or to end, with the reason. */
  private sealed interface Wish {
    record Start(int index) implements Wish {}

    record End(String why, boolean stay) implements Wish {}
  }

  /** On the way to a waypoint: the goal that was given, where the robot was when it last moved, and when. */
  private record Leg(int index, RigidTransform goal, Optional<RigidTransform> last, long movedNanos) {}

  /** Begins at a waypoint, by its index from 0. */
  public void start(int index) {
    wish.set(Optional.of(new Wish.Start(index)));
  }

  /** Ends it, and has the robot stay where it is then. */
  public void halt() {
    wish.set(Optional.of(new Wish.End("you ended it", true)));
  }

  /** Ends it, as something else commands the robot now. */
  public void cede(String why) {
    wish.set(Optional.of(new Wish.End(why, false)));
  }

  /** Whether there is something to be done with the next tick. */
  public boolean busy() {
    return leg.isPresent() || wish.get().isPresent();
  }

  /** The waypoint that is driven to; none while it does not drive. */
  public OptionalInt driving() {
    return leg.map(l -> OptionalInt.of(l.index)).orElseGet(OptionalInt::empty);
  }

  /**
   * Goes on.
   *
   * @param route the waypoints as they are now, in a frame that is known
   * @param frameFromBase where the robot is in their frame, if known
   * @param tolerance how near is near enough, metres
   * @param nowNanos now
   */
  public void tick(Route route, Optional<RigidTransform> frameFromBase, double tolerance, long nowNanos) {
    wish.getAndSet(Optional.empty()).ifPresent(w -> fulfil(w, route, frameFromBase, nowNanos));
    leg.ifPresent(now -> hindrance(now, route, nowNanos).ifPresentOrElse(why -> end(why, now, route),
        () -> go(now, route, frameFromBase, tolerance, nowNanos)));
  }

  private void fulfil(Wish wished, Route route, Optional<RigidTransform> frameFromBase, long nowNanos) {
    switch (wished) {
      case Wish.Start start when route.poses().isEmpty() || start.index >= route.poses().size() -> tell
          .accept(new CommandNotice(Health.BAD, "There is no waypoint to drive to: R places them"));
      case Wish.Start start -> send(start.index, route, frameFromBase, nowNanos);
      case Wish.End ended -> leg.ifPresent(now -> {
        end(ended.why, now, route);
        if (ended.stay) {
          frameFromBase.ifPresent(base -> route.frame().ifPresent(frame -> commander.goal(frame, base)));
        }
      });
    }
  }

  /** What takes the robot out of the user's hands. */
  private Optional<String> hindrance(Leg now, Route route, long nowNanos) {
    Authority authority = goals.authority();
    if (authority.stoppedBy().isPresent()) {
      return Optional.of("stopped by " + authority.stoppedBy().get().label());
    }
    if (authority.holder().filter(principal::equals).isEmpty()) {
      return Optional.of(authority.holder().map(other -> other.label() + " controls " + authority.robot() + " now")
          .orElse("control was released"));
    }
    if (!(goals.state() instanceof InputState.Live)) {
      return Optional.of(goals.state().explanation());
    }
    if (now.index >= route.poses().size()) {
      return Optional.of("the waypoint was removed");
    }
    return nowNanos - now.movedNanos > PATIENCE_NANOS
        ? Optional.of("the robot has not moved for " + PATIENCE_NANOS / 1_000_000_000L + " s")
        : Optional.empty();
  }

  private void go(Leg now, Route route, Optional<RigidTransform> frameFromBase, double tolerance, long nowNanos) {
    RigidTransform wanted = route.poses().get(now.index);
    if (!wanted.equals(now.goal)) {
      send(now.index, route, frameFromBase, nowNanos);
    } else if (frameFromBase.filter(base -> isNear(base, wanted, tolerance)).isPresent()) {
      arrived(now, route, frameFromBase, nowNanos);
    } else if (frameFromBase.filter(base -> now.last.filter(last -> !hasMoved(last, base)).isEmpty()).isPresent()) {
      leg = Optional.of(new Leg(now.index, now.goal, frameFromBase, nowNanos));
    }
  }

  private void arrived(Leg now, Route route, Optional<RigidTransform> frameFromBase, long nowNanos) {
    if (now.index + 1 < route.poses().size()) {
      send(now.index + 1, route, frameFromBase, nowNanos);
    } else {
      leg = Optional.empty();
      tell.accept(new CommandNotice(Health.OK, "The last waypoint is reached"));
    }
  }

  private void send(int index, Route route, Optional<RigidTransform> frameFromBase, long nowNanos) {
    RigidTransform goal = route.poses().get(index);
    CommandNotice told = route.frame().map((FrameId frame) -> commander.goal(frame, goal))
        .orElse(new CommandNotice(Health.BAD, "no frame is known yet"));
    if (told.health() == Health.OK) {
      leg = Optional.of(new Leg(index, goal, frameFromBase, nowNanos));
    } else {
      leg = Optional.empty();
      tell.accept(new CommandNotice(Health.BAD, "Waypoint " + (index + 1) + ": " + told.text()));
    }
  }

  private void end(String why, Leg now, Route route) {
    leg = Optional.empty();
    tell.accept(new CommandNotice(Health.WARNING,
        "The drive ended at waypoint " + (now.index + 1) + " of " + route.poses().size() + ": " + why));
  }

  private static boolean isNear(RigidTransform base, RigidTransform wanted, double tolerance) {
    double distance = Math.hypot(base.translation().x() - wanted.translation().x(),
        base.translation().y() - wanted.translation().y());
    return distance <= tolerance && turn(base, wanted) <= NEAR_RADIANS;
  }

  private static boolean hasMoved(RigidTransform last, RigidTransform base) {
    return last.translation().minus(base.translation()).norm() > STEP_METRES || turn(last, base) > STEP_METRES;
  }

  private static double turn(RigidTransform a, RigidTransform b) {
    return Math.abs(Math.IEEEremainder(a.rotation().yaw() - b.rotation().yaw(), 2 * Math.PI));
  }
}
