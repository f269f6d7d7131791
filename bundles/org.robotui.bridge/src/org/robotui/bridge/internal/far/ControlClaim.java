package org.robotui.bridge.internal.far;

import java.util.Optional;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.Principal;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;

/**
 * The lease of a bridge that commands a robot. It is taken with the first command where nobody has it, never from
 * somebody else, and given back when no commands come. After a stop, or after somebody else had control, the bridge
 * waits until whoever commands has been silent or at rest: nothing moves because a stop was released.
 */
final class ControlClaim {
  private static final long SILENCE = 1_000_000_000L;
  private static final long IDLE = 5_000_000_000L;

  private final Principal principal;
  private Optional<String> interrupted = Optional.empty();
  private long commandedAt = System.nanoTime() - SILENCE;

  ControlClaim(Principal principal) {
    this.principal = principal;
  }

  /** Why the robot must not be commanded now; takes the lease where it may be. */
  Optional<String> obstacle(Authority authority, Data command, long now) {
    return obstacle(authority, command instanceof Motion<?> motion && motion.equals(motion.stopped()), now);
  }

  /** The same of what is no message: whether it asks for rest. */
  Optional<String> obstacle(Authority authority, boolean rests, long now) {
    if (rests || now - commandedAt >= SILENCE) {
      interrupted = Optional.empty();
    }
    commandedAt = now;
    if (authority.stoppedBy().isPresent()) {
      interrupted = Optional.of("the stop by " + authority.stoppedBy().get().label());
      return Optional.of(authority.robot() + " is stopped by " + authority.stoppedBy().get().label()
          + "; release the stop first");
    }
    if (interrupted.isPresent()) {
      return Optional.of("since " + interrupted.get() + ", commands have not paused for a second; they pass again when"
          + " they have");
    }
    return lease(authority);
  }

  private Optional<String> lease(Authority authority) {
    if (authority.take(principal, false) instanceof LeaseOutcome.HeldBy held) {
      interrupted = Optional.of(held.holder().label() + " took control");
      return Optional.of(held.holder().label() + " has control of " + authority.robot()
          + "; it passes when control is given back");
    }
    return Optional.empty();
  }

  /** Gives the lease back where no commands come. */
  void tick(Optional<Authority> authority, long now) {
    if (now - commandedAt > IDLE) {
      authority.ifPresent(this::giveBack);
    }
  }

  void giveBack(Authority authority) {
    if (authority.holder().filter(principal::equals).isPresent()) {
      authority.giveBack(principal);
    }
  }
}
