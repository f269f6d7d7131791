package org.robotui.testkit.host;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;

/** An authority that keeps lease and stop and moves nothing. Safe for all threads. */
public final class FakeAuthority implements Authority {
  private final String robot;
  private final AtomicReference<Optional<Principal>> holder = new AtomicReference<>(Optional.empty());
  private final AtomicReference<Optional<Principal>> stoppedBy = new AtomicReference<>(Optional.empty());

  /**
   * An authority without holder, not stopped.
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
  public Optional<Principal> holder() {
    return holder.get();
  }

  @Override
  public LeaseOutcome take(Principal principal, boolean takeover) {
    Optional<Principal> now = holder.updateAndGet(h -> takeover || h.isEmpty() ? Optional.of(principal) : h);
    return now.filter(principal::equals).isPresent()
        ? new LeaseOutcome.Granted()
        : new LeaseOutcome.HeldBy(now.orElseThrow());
  }

  @Override
  public void giveBack(Principal principal) {
    holder.updateAndGet(h -> h.filter(p -> !p.equals(principal)));
  }

  @Override
  public void stop(Principal by) {
    stoppedBy.compareAndSet(Optional.empty(), Optional.of(by));
  }

  @Override
  public void releaseStop(Principal by) {
    stoppedBy.set(Optional.empty());
  }

  @Override
  public Optional<Principal> stoppedBy() {
    return stoppedBy.get();
  }
}
