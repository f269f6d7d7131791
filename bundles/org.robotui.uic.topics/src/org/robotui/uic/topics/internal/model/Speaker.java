package org.robotui.uic.topics.internal.model;

import java.time.Duration;
import java.util.Optional;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.command.MessageCommand;
import org.robotui.ui.Health;

/**
 * Says messages, once or again and again. Repeating ends when the user looks away, the lease or the stop changes, or a
 * message is refused: what nobody watches is not said. All threads; never blocks.
 */
public final class Speaker {
  /** The slowest and the fastest repetition, hertz. */
  public static final double SLOWEST = 0.1;
  public static final double FASTEST = 50;

  private static final Duration VALID = Duration.ofSeconds(2);
  private static final long WATCHED_NANOS = 1_000_000_000L;
  private static final double NANOS = 1e9;

  private final Output<MessageCommand> output;
  private final Principal principal;
  private Optional<MessageCommand> repeated = Optional.empty();
  private double hertz;
  private long due;
  private long watched;
  private long said;
  private boolean asking;
  private Health health = Health.NONE;
  private String outcome = "";

  Speaker(Output<MessageCommand> output, Principal principal) {
    this.output = output;
    this.principal = principal;
  }

  /** Why nothing can be said to a robot, none where it can. */
  public Optional<String> obstacle(String robot) {
    if (output.state() instanceof InputState.Unconnected none) {
      return Optional.of(none.explanation());
    }
    return output.targets().stream().map(SourceId::component).anyMatch(robot::equals)
        ? Optional.empty()
        : Optional.of("messages of this view go to "
            + output.targets().stream().map(SourceId::component).findFirst().orElse("nobody") + ", not to " + robot);
  }

  /** Says a message now; takes the lease where nobody has it, else asks. */
  public synchronized void once(MessageCommand message) {
    end();
    if (granted(false)) {
      said = 0;
      say(message);
    }
  }

  /** Says a message now and again and again. */
  public synchronized void repeat(MessageCommand message, double rate, long now) {
    end();
    if (granted(false)) {
      said = 0;
      hertz = Math.clamp(rate, SLOWEST, FASTEST);
      repeated = Optional.of(message);
      watched = now;
      due = now;
      tick(now);
    }
  }

  /** What is repeated from now on, where something is. */
  public synchronized void change(MessageCommand message) {
    repeated = repeated.map(before -> message);
  }

  /** The user still looks at it: a repetition goes on for another second. */
  public synchronized void watched(long now) {
    watched = now;
  }

  /** Ends a repetition. */
  public synchronized void stop(String why) {
    if (repeated.isPresent()) {
      end();
      tell(Health.NONE,
          "Ended after " + said + (said == 1 ? " message" : " messages") + (why.isEmpty() ? "" : ": " + why));
    }
  }

  /** The user confirmed to take the robot over. */
  public synchronized void takeOver() {
    if (granted(true)) {
      tell(Health.NONE, "You have control of " + output.authority().robot());
    }
  }

  /** The user does not want to take the robot over. */
  public synchronized void leave() {
    asking = false;
  }

  /** Says what is due. */
  synchronized void tick(long now) {
    if (repeated.isEmpty()) {
      return;
    }
    Optional<String> end = reasonToEnd(now);
    if (end.isPresent()) {
      stop(end.get());
    } else if (now - due >= 0) {
      long period = (long) (NANOS / hertz);
      due = Math.max(due + period, now + period / 2);
      say(repeated.get());
    }
  }

  synchronized Speech look() {
    return new Speech(lease(), asking && !(lease() instanceof Speech.Lease.Mine),
        repeated.map(m -> hertz), said, health, outcome);
  }

  private Optional<String> reasonToEnd(long now) {
    if (now - watched > WATCHED_NANOS) {
      return Optional.of("the view lost the focus");
    }
    Authority authority = output.authority();
    if (authority.stoppedBy().isPresent()) {
      return Optional.of(authority.robot() + " is stopped");
    }
    return authority.holder().filter(principal::equals).isPresent() ? Optional.empty()
        : Optional.of(authority.holder().map(h -> h.label() + " has control of ").orElse("nobody has control of ")
            + authority.robot());
  }

  private void say(MessageCommand message) {
    switch (output.send(message, VALID)) {
      case CommandOutcome.Accepted a -> {
        said++;
        tell(Health.OK,
            said == 1 ? "Published on " + message.topic() : said + " messages published on " + message.topic());
      }
      case CommandOutcome.Refused refused -> {
        end();
        tell(Health.BAD, "Not published: " + refused.explanation());
      }
    }
  }

  private boolean granted(boolean takeover) {
    if (output.authority().take(principal, takeover) instanceof LeaseOutcome.HeldBy held) {
      asking = true;
      tell(Health.WARNING, held.holder().label() + " has control of " + output.authority().robot());
      return false;
    }
    asking = false;
    return true;
  }

  private Speech.Lease lease() {
    return output.authority().holder()
        .map(holder -> holder.equals(principal) ? new Speech.Lease.Mine() : new Speech.Lease.Other(holder.label()))
        .orElseGet(Speech.Lease.Free::new);
  }

  private void end() {
    repeated = Optional.empty();
  }

  private void tell(Health dot, String words) {
    health = dot;
    outcome = words;
  }
}
