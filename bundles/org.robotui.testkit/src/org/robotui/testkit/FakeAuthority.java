package org.robotui.testkit;

import java.util.Optional;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.data.command.MotionLimits;

/** An authority with the rules of the real one: one holder, takeover only when confirmed, a stop that stays. */
public final class FakeAuthority implements Authority {
  /** The user at this window. */
  public static final Principal YOU = new Principal("you", "You", Principal.Kind.WINDOW);

  /** Somebody else. */
  public static final Principal ANNA = new Principal("anna", "Anna", Principal.Kind.WINDOW);

  private final String robot;
  private Optional<Principal> holder = Optional.empty();
  private Optional<Principal> stopper = Optional.empty();
  private MotionLimits limits = MotionLimits.NONE;

  /**
   * Nobody drives, nothing is stopped.
   *
   * @param robot the robot's name
   */
  public FakeAuthority(String robot) {
    this.robot = robot;
  }

  @Override
  public String robot() {
    return robot;
  }

  @Override
  public synchronized Optional<Principal> holder() {
    return holder;
  }

  @Override
  public synchronized LeaseOutcome take(Principal principal, boolean takeover) {
    if (holder.isEmpty() || takeover || holder.get().equals(principal)) {
      holder = Optional.of(principal);
      return new LeaseOutcome.Granted();
    }
    return new LeaseOutcome.HeldBy(holder.get());
  }

  @Override
  public synchronized void giveBack(Principal principal) {
    holder = holder.filter(held -> !held.equals(principal));
  }

  @Override
  public synchronized void stop(Principal by) {
    stopper = Optional.of(by);
  }

  @Override
  public synchronized void releaseStop(Principal by) {
    stopper = Optional.empty();
  }

  @Override
  public synchronized Optional<Principal> stoppedBy() {
    return stopper;
  }

  @Override
  public synchronized MotionLimits limits() {
    return limits;
  }

  /**
   * Limits the robot.
   *
   * @param to the limits from now on
   */
  public synchronized void limit(MotionLimits to) {
    limits = to;
  }
}
