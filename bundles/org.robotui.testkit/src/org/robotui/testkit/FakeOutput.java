package org.robotui.testkit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;

/**
 * An output that keeps what is sent. It accepts all commands unless the test says otherwise.
 *
 * @param <T> the type of the commands
 */
public final class FakeOutput<T extends Data> implements Output<T> {
  /**
   * A command as it was given.
   *
   * @param <T> the type of the commands
   * @param command the command
   * @param validFor how long it is true
   * @param targets where it was given to
   */
  public record Sent<T>(T command, Duration validFor, List<SourceId> targets) {}

  private final FakeAuthority authority;
  private final List<Sent<T>> sent = new ArrayList<>();
  private InputState state = new InputState.Live(0, 0);
  private List<SourceId> targets = List.of(new SourceId("base", "cmd"));
  private Supplier<CommandOutcome> outcome = CommandOutcome.Accepted::new;
  private int releases;

  /**
   * An output to a robot.
   *
   * @param authority over that robot
   */
  public FakeOutput(FakeAuthority authority) {
    this.authority = authority;
  }

  /**
   * Sets what becomes of commands from now on.
   *
   * @param next asked for each command
   */
  public synchronized void outcome(Supplier<CommandOutcome> next) {
    outcome = next;
  }

  /**
   * Sets the state; unconnected takes the targets away.
   *
   * @param next the state from now on
   */
  public synchronized void state(InputState next) {
    state = next;
    targets = next instanceof InputState.Unconnected ? List.of() : List.of(new SourceId("base", "cmd"));
  }

  /**
   * All that was sent.
   *
   * @return in order
   */
  public synchronized List<Sent<T>> sent() {
    return List.copyOf(sent);
  }

  /**
   * How often the motion was ended.
   *
   * @return calls of {@link #release()}
   */
  public synchronized int releases() {
    return releases;
  }

  @Override
  public synchronized CommandOutcome send(T command, Duration validFor) {
    sent.add(new Sent<>(command, validFor, targets));
    return outcome.get();
  }

  @Override
  public synchronized CommandOutcome send(SourceId target, T command, Duration validFor) {
    sent.add(new Sent<>(command, validFor, List.of(target)));
    return outcome.get();
  }

  /**
   * Sets where commands go.
   *
   * @param next the targets from now on
   */
  public synchronized void targets(List<SourceId> next) {
    targets = List.copyOf(next);
  }

  @Override
  public synchronized void release() {
    releases++;
  }

  @Override
  public synchronized List<SourceId> targets() {
    return targets;
  }

  @Override
  public synchronized InputState state() {
    return state;
  }

  @Override
  public FakeAuthority authority() {
    return authority;
  }
}
