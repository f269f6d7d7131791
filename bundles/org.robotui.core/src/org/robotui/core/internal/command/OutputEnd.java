package org.robotui.core.internal.command;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.command.Authority;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RateMeter;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.data.Data;

/** A view's end of a command port. Matching changes its targets while it is used. */
public final class OutputEnd<T extends Data> implements Output<T> {
  private record Targets<T extends Data>(List<CommandTarget<T>> all, String reason) {}

  private final Principal principal;
  private final Supplier<Authority> fallback;
  private final NanoClock clock;
  private volatile Targets<T> targets = new Targets<>(List.of(), "not matched yet");

  /**
   * An end without targets.
   *
   * @param principal as whom the view gives commands
   * @param fallback the authority to show where there is no target
   * @param clock monotonic
   */
  public OutputEnd(Principal principal, Supplier<Authority> fallback, NanoClock clock) {
    this.principal = principal;
    this.fallback = fallback;
    this.clock = clock;
  }

  /** Connects it to these targets; what it moved at those that go is stopped. */
  public void connect(List<CommandTarget<T>> connected, String reason) {
    List<CommandTarget<T>> before = targets.all();
    targets = new Targets<>(List.copyOf(connected), reason);
    before.stream().filter(t -> !connected.contains(t)).forEach(t -> t.arbiter().release(this));
  }

  @Override
  public CommandOutcome send(T command, Duration validFor) {
    Targets<T> now = targets;
    Optional<CommandOutcome> refused = Optional.empty();
    boolean accepted = false;
    for (CommandTarget<T> target : now.all()) {
      CommandOutcome outcome = target.arbiter().send(this, principal, target, command, validFor);
      accepted |= outcome instanceof CommandOutcome.Accepted;
      refused = refused.or(() -> Optional.of(outcome).filter(CommandOutcome.Refused.class::isInstance));
    }
    CommandOutcome none = new CommandOutcome.Refused(CommandOutcome.Why.NOT_CONNECTED, now.reason());
    return accepted ? new CommandOutcome.Accepted() : refused.orElse(none);
  }

  @Override
  public CommandOutcome send(SourceId target, T command, Duration validFor) {
    Targets<T> now = targets;
    return now.all().stream().filter(t -> t.id().equals(target)).findFirst()
        .map(t -> t.arbiter().send(this, principal, t, command, validFor))
        .orElseGet(() -> new CommandOutcome.Refused(CommandOutcome.Why.NOT_CONNECTED,
            target + " is not connected; " + now.reason()));
  }

  @Override
  public void release() {
    targets.all().forEach(t -> t.arbiter().release(this));
  }

  @Override
  public List<SourceId> targets() {
    return targets.all().stream().map(CommandTarget::id).toList();
  }

  @Override
  public InputState state() {
    Targets<T> now = targets;
    return now.all().stream().findFirst().map(this::state)
        .orElseGet(() -> new InputState.Unconnected(now.reason()));
  }

  private InputState state(CommandTarget<T> target) {
    if (!target.link().isUp()) {
      return new InputState.Waiting(target.id() + ": no link (" + target.link().text() + ")");
    }
    RateMeter rate = target.sent().rate();
    double age = target.sent().last().map(e -> e.ageSeconds(clock.nanos())).orElse(0.0);
    return target.problem().isEmpty()
        ? new InputState.Live(rate.rateHz(clock.nanos()), age)
        : new InputState.Failed(target.id() + ": " + target.problem());
  }

  @Override
  public Authority authority() {
    return targets.all().stream().findFirst().<Authority>map(CommandTarget::arbiter).orElseGet(fallback);
  }
}
