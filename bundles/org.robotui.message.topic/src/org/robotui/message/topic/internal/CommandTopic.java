package org.robotui.message.topic.internal;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Offer;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;
import org.robotui.message.data.CommandType;
import org.robotui.message.topic.TopicPublisher;

/**
 * A topic as a command port. It is advertised as soon as it is offered, as a first command would else be lost while its
 * subscribers connect; it never latches, so that nothing is said twice.
 */
final class CommandTopic implements AutoCloseable {
  /** How long a stop at the end may take, where somebody listens who does not read. */
  private static final Duration STOP = Duration.ofMillis(300);

  private final String topic;
  private final String type;
  private final Pulse pulse;
  private final BooleanSupplier base;
  private final Entry<?, ?> entry;

  CommandTopic(String topic, CommandType<?, ?> command, TopicScope scope, BooleanSupplier base) {
    this.topic = topic;
    this.type = command.type();
    this.pulse = scope.pulse();
    this.base = base;
    this.entry = new Entry<>(command, scope);
  }

  String type() {
    return type;
  }

  /** Stops what we drive, where core has not done so; what others drive is left alone. */
  @Override
  public void close() {
    entry.offer.close();
    entry.stop();
    entry.publisher.close();
  }

  /** Holds the types of one command together. */
  private final class Entry<D extends Data, M extends Record> implements CommandSink<D> {
    private final CommandType<D, M> command;
    private final SessionClock clock;
    private final TopicPublisher<M> publisher;
    private final Offer offer;
    /** What we drive with now, from when it is sent until a stop is. */
    private volatile Optional<Motion<?>> driven = Optional.empty();

    Entry(CommandType<D, M> command, TopicScope scope) {
      this.command = command;
      this.clock = scope.clock();
      this.publisher = scope.client().commands(topic, command.type(), command.form(), 1);
      this.offer = scope.context().offers().command(
          new CommandPort<>(scope.settings().portName(topic), command.data(), Arity.MANY,
              topic + ": " + command.help()),
          this);
    }

    @Override
    public Sent stop(D zero, boolean ours) {
      return ours || base.getAsBoolean() ? send(zero) : new Sent.Unneeded();
    }

    @Override
    public Sent send(D value) {
      if (publisher.subscribers() == 0) {
        return new Sent.Refused(publisher.obstacle().orElse("nobody subscribes to " + topic + " now"));
      }
      boolean stops = value instanceof Motion<?> motion && motion.equals(motion.stopped());
      long silence = stops ? 0 : pulse.silentFor(System.nanoTime());
      if (silence > 0) {
        return new Sent.Refused(stalled(silence));
      }
      driven = value instanceof Motion<?> motion && !stops ? Optional.of(motion) : Optional.empty();
      return publish(command.message().of(value, clock.nowNanos()), stops);
    }

    void stop() {
      driven.map(Motion::stopped)
          .ifPresent(zero -> publish(command.message().of(command.data().cast(zero), clock.nowNanos()), true));
      driven = Optional.empty();
      publisher.awaitSent(STOP); // core may have sent a stop a moment ago: closing would drop it
    }

    private Sent publish(M message, boolean stops) {
      if (stops) {
        publisher.publishUrgently(message);
      } else {
        publisher.publish(message);
      }
      return new Sent.Out();
    }

    private static String stalled(long silenceNanos) {
      return String.format(Locale.ROOT,
          "the robot has not been heard for %.1f s; nothing is sent into a network that may keep it",
          silenceNanos / 1e9);
    }
  }
}
