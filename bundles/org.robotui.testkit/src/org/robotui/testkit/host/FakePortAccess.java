package org.robotui.testkit.host;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import org.robotui.api.command.Authority;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Principal;
import org.robotui.api.host.PortAccess;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.command.RelayMessage;

/**
 * Ports that a test fills, and that note down what is sent. Commands need the lease and are refused while the stop is
 * latched, as those of core. Safe for all threads.
 */
public final class FakePortAccess implements PortAccess {
  private record Key(PortKind kind, SourceId id) {}

  private final Authority authority;
  private final Map<Key, Port> ports = new HashMap<>();
  private final Map<SourceId, Envelope<?>> newest = new HashMap<>();
  private final Map<SourceId, Queue<Envelope<?>>> queues = new HashMap<>();
  private final Map<SourceId, Long> skipped = new HashMap<>();
  private final Map<SourceId, List<RawMessage>> held = new HashMap<>();
  private final Map<SourceId, Browser> browsers = new HashMap<>();
  private final List<String> sent = new CopyOnWriteArrayList<>();
  private final List<Data> commands = new CopyOnWriteArrayList<>();
  private BiFunction<Object, Progress, CompletionStage<CallOutcome<Object>>> answers =
      (request, progress) -> CompletableFuture.completedStage(new CallOutcome.Failed<>("no test answers"));
  private volatile Principal principal = new Principal("nobody", "Nobody", Principal.Kind.SCRIPT);

  FakePortAccess(Authority authority) {
    this.authority = authority;
  }

  FakePortAccess as(Principal who) {
    principal = who;
    return this;
  }

  /**
   * Offers ports of a robot interface.
   *
   * @param component its id
   * @param offered the ports
   * @return this
   */
  public synchronized FakePortAccess offer(String component, Port... offered) {
    for (Port port : offered) {
      ports.put(new Key(port.kind(), new SourceId(component, port.name())), port);
    }
    return this;
  }

  /**
   * Takes ports away, as when a robot has gone.
   *
   * @param component id of the robot interface
   */
  public synchronized void withdraw(String component) {
    ports.keySet().removeIf(key -> key.id().component().equals(component));
  }

  /**
   * A robot sends.
   *
   * @param stream which port
   * @param value what
   */
  public synchronized void put(SourceId stream, Data value) {
    put(stream, value, Optional.empty(), Optional.empty());
  }

  /**
   * A robot sends a message.
   *
   * @param stream which port
   * @param value what
   * @param stamp when it was measured
   * @param raw the message as it came
   */
  public synchronized void put(SourceId stream, Data value, Optional<Stamp> stamp, Optional<RawMessage> raw) {
    long sequence = Optional.<Envelope<?>>ofNullable(newest.get(stream)).map(e -> e.sequence() + 1).orElse(0L)
        + skipped.getOrDefault(stream, 0L);
    skipped.remove(stream);
    Envelope<?> envelope = new Envelope<>(value, stream, sequence, stamp, System.nanoTime(), raw);
    newest.put(stream, envelope);
    queues.computeIfAbsent(stream, s -> new ArrayDeque<>()).add(envelope);
  }

  /**
   * Values are lost before the next one.
   *
   * @param stream which port
   * @param count how many
   */
  public synchronized void drop(SourceId stream, long count) {
    skipped.merge(stream, count, Long::sum);
  }

  /**
   * Sets the messages of a stream that hold.
   *
   * @param stream which port
   * @param messages the messages
   */
  public synchronized void hold(SourceId stream, List<RawMessage> messages) {
    held.put(stream, List.copyOf(messages));
  }

  @Override
  public synchronized Optional<List<RawMessage>> held(SourceId stream) {
    return Optional.ofNullable(held.get(stream));
  }

  /**
   * Lets a robot be browsed.
   *
   * @param port where
   * @param browser answers
   */
  public synchronized void browse(SourceId port, Browser browser) {
    browsers.put(port, browser);
  }

  /**
   * Sets how calls end.
   *
   * @param by is given the request
   */
  public synchronized void answer(Function<Object, CallOutcome<Object>> by) {
    answers = (request, progress) -> CompletableFuture.completedStage(by.apply(request));
  }

  /**
   * Sets how calls end, perhaps later.
   *
   * @param by is given the request, and what is told of progress
   */
  public synchronized void answerLater(BiFunction<Object, Progress, CompletionStage<CallOutcome<Object>>> by) {
    answers = by;
  }

  /**
   * What was sent and asked, in order.
   *
   * @return for example {@code base.cmd_vel VelocityCommand[...]}, {@code release} and {@code close}
   */
  public List<String> sent() {
    return List.copyOf(sent);
  }

  @Override
  public Principal principal() {
    return principal;
  }

  @Override
  public synchronized Optional<Port> port(PortKind kind, SourceId id) {
    return Optional.ofNullable(ports.get(new Key(kind, id)));
  }

  @Override
  public synchronized Optional<Envelope<?>> newest(SourceId stream) {
    return Optional.ofNullable(newest.get(stream));
  }

  @Override
  public synchronized int take(SourceId stream, Consumer<? super Envelope<?>> consumer) {
    Queue<Envelope<?>> queue = queues.computeIfAbsent(stream, s -> new ArrayDeque<>());
    int count = queue.size();
    queue.forEach(consumer);
    queue.clear();
    return count;
  }

  @Override
  public synchronized InputState state(SourceId stream) {
    return newest.containsKey(stream) ? new InputState.Live(10, 0)
        : ports.containsKey(new Key(PortKind.STREAM, stream)) ? new InputState.Waiting(stream + ": no data yet")
            : new InputState.Unconnected("no stream " + stream + " is offered now");
  }

  @Override
  public CommandOutcome send(SourceId target, Data command, Duration validFor) {
    if (command instanceof RelayMessage relayed && !relayed.guarded()) {
      return accept(target, command);
    }
    if (authority.stoppedBy().isPresent()) {
      return new CommandOutcome.Refused(CommandOutcome.Why.STOPPED, authority.robot() + " is stopped");
    }
    if (authority.holder().filter(principal::equals).isEmpty()) {
      return new CommandOutcome.Refused(CommandOutcome.Why.NO_LEASE,
          "nobody has control of " + authority.robot() + "; take control first");
    }
    return accept(target, command);
  }

  private CommandOutcome accept(SourceId target, Data command) {
    sent.add(target + " " + command);
    commands.add(command);
    if (command instanceof RelayMessage relayed) {
      relayed.answer().told(Optional.empty());
    }
    return new CommandOutcome.Accepted();
  }

  /**
   * The commands that were accepted.
   *
   * @return in order
   */
  public List<Data> commands() {
    return List.copyOf(commands);
  }

  @Override
  public void release() {
    sent.add("release");
  }

  @Override
  public synchronized Call<?> call(SourceId target, Object request, Duration timeout, Progress progress) {
    sent.add(target + " " + request);
    CompletionStage<CallOutcome<Object>> outcome = answers.apply(request, progress);
    return new Call<Object>() {
      @Override
      public CompletionStage<CallOutcome<Object>> outcome() {
        return outcome;
      }

      @Override
      public void cancel() {
        sent.add("cancel");
      }
    };
  }

  @Override
  public synchronized Optional<Browser> browser(SourceId port) {
    return Optional.ofNullable(browsers.get(port));
  }

  @Override
  public void close() {
    sent.add("close");
  }
}
