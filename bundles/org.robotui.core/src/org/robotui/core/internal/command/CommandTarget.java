package org.robotui.core.internal.command;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.command.Outbox.Purpose;
import org.robotui.core.internal.port.Fan;
import org.robotui.core.internal.port.Link;
import org.robotui.core.internal.port.Offered;
import org.robotui.core.internal.port.ValueText;
import org.robotui.core.internal.port.Withdrawal;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A way to command a robot, as offered. What went out can be tapped like any stream. */
public final class CommandTarget<T extends Data> implements Offered {
  private static final Logger LOG = LoggerFactory.getLogger(CommandTarget.class);
  private static final long SLOW_NANOS = Duration.ofMillis(20).toNanos();

  private final SourceId id;
  private final CommandPort<T> port;
  private final CommandSink<T> sink;
  private final Link link;
  private final Arbiter arbiter;
  private final Sender sender;
  private final NanoClock clock;
  private final Withdrawal withdrawal;
  private final Fan<T> sent;
  private final Outbox<T> outbox;
  private final AtomicBoolean closed = new AtomicBoolean();
  private final AtomicBoolean warned = new AtomicBoolean();
  private volatile Optional<T> zero;
  private volatile boolean ending;
  private volatile String problem = "";
  private volatile StopAnswer stopAnswer = StopAnswer.TAKEN;

  /** Made by the table of offers. */
  public CommandTarget(
      SourceId id, CommandPort<T> port, CommandSink<T> sink, Link link, Arbiter arbiter, Sender sender, NanoClock clock,
      Withdrawal withdrawal) {
    this.id = id;
    this.port = port;
    this.sink = sink;
    this.link = link;
    this.arbiter = arbiter;
    this.sender = sender;
    this.clock = clock;
    this.withdrawal = withdrawal;
    this.outbox = new Outbox<>(id.port(), this::deliver);
    this.sent = new Fan<>(id, DataType.of(port.type()), clock.nanos());
    this.zero = port.isMotion() ? Zeros.of(port.type()) : Optional.empty();
    if (port.isMotion() && zero.isEmpty()) {
      LOG.warn("{} takes {}, which has no constant ZERO: a stop reaches it only after its first command", id,
          port.typeName());
    }
  }

  /** Gives a command to the sender. */
  boolean post(T command, long deadline) {
    Zeros.of(command).ifPresent(z -> zero = Optional.of(z));
    return sender.post(outbox, new Outbox.Pending<>(command, deadline, link.generation(), Purpose.COMMAND));
  }

  /** Gives the stop to the sender, before all else. */
  public void postZero() {
    postZero(Purpose.COMMAND);
  }

  /** Gives the zero of a latched stop to the sender, before all else. */
  void postStop(boolean ours) {
    postZero(ours ? Purpose.OUR_STOP : Purpose.STOP);
  }

  private void postZero(Purpose purpose) {
    zero.ifPresent(z -> sender.postStop(outbox, new Outbox.Pending<>(z, Long.MAX_VALUE, link.generation(), purpose)));
  }

  /** Forgets what was not sent yet. */
  void clear() {
    sender.clear(outbox);
  }

  /** Sends one. The sender calls it on its thread, without its lock. */
  private void deliver(Outbox.Pending<T> next) {
    if (next.generation() != link.generation() || clock.nanos() > next.deadline() || closed.get()) {
      return;
    }
    long start = clock.nanos();
    send(next.command(), next.purpose());
    long took = clock.nanos() - start;
    if (took > SLOW_NANOS && warned.compareAndSet(false, true)) {
      LOG.warn("{} took {} ms to send a command; it must not block", id, took / 1_000_000);
    }
  }

  private void send(T command, Purpose purpose) {
    try {
      switch (purpose == Purpose.COMMAND ? sink.send(command) : stop(command, purpose == Purpose.OUR_STOP)) {
        case CommandSink.Sent.Out out -> {
          problem = "";
          sent.publish(command, Optional.empty(), clock.nanos(), Optional.empty());
        }
        case CommandSink.Sent.Refused refused -> refuse(refused.reason(), purpose);
        case CommandSink.Sent.Unneeded unneeded -> LOG.debug("{} needs no stop: nobody drove there from here", id);
      }
    } catch (RuntimeException | LinkageError e) {
      LOG.warn("{} failed to send a command", id, e);
      refuse("the robot interface failed to send: " + e, purpose);
    }
  }

  private CommandSink.Sent stop(T command, boolean ours) {
    stopAnswer = StopAnswer.LOST;
    CommandSink.Sent answer = sink.stop(command, ours);
    stopAnswer = StopAnswer.of(answer);
    return answer;
  }

  private void refuse(String reason, Purpose purpose) {
    switch (purpose) {
      case COMMAND -> refuse(reason);
      case OUR_STOP -> refuse("the stop did not get there and is said again: " + reason);
      case STOP -> LOG.info("{} did not take the stop, and nobody drove there from here: {}", id, reason);
    }
  }

  private void refuse(String reason) {
    boolean isNew = problem.isEmpty();
    problem = reason;
    if (isNew) {
      arbiter.report(id + ": " + reason);
    }
  }

  /** What became of the latest stop that was latched. */
  StopAnswer stopAnswer() {
    return stopAnswer;
  }

  /** Why nothing is sent here any more; empty where that is not so. */
  public String fence() {
    return outbox.fence();
  }

  /** Why the last command did not go out; empty where it did. */
  public String problem() {
    return outbox.fence().isEmpty() ? problem : outbox.fence();
  }

  /** Who decides. */
  public Arbiter arbiter() {
    return arbiter;
  }

  /** The link that commands take. */
  public Link link() {
    return link;
  }

  /** What went out. */
  public Fan<T> sent() {
    return sent;
  }

  /** Refuses commands from now on, so that the zero that is sent at the end is the last. */
  void takeNoMore() {
    ending = true;
  }

  boolean isClosed() {
    return ending || closed.get();
  }

  @Override
  public SourceId id() {
    return id;
  }

  @Override
  public CommandPort<T> port() {
    return port;
  }

  @Override
  public PortStatus status(NanoClock moment) {
    Optional<Envelope<T>> last = sent.last();
    long now = moment.nanos();
    double age = last.map(e -> e.ageSeconds(now)).orElse(Double.NaN);
    String value = last.map(e -> ValueText.of(e.value())).orElse("");
    return new PortStatus(id, port.kind(), port.typeName(), arbiter.drives(this), sent.rate().count(),
        sent.rate().rateHz(now), age, false, sent.dropped(), problem(), value);
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      arbiter.forget(this);
      withdrawal.withdrawn(this);
    }
  }
}
