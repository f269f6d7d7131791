package org.robotui.rfic.ros.internal.graph;

import java.util.Optional;
import java.util.function.Function;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.FrameNames;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.rfic.ros.internal.convert.MessageReading;
import org.robotui.rfic.ros.internal.convert.RecordDecoder;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/**
 * A topic as a stream. The robot is only asked for it while somebody wants it. Core's thread merely notes the demand;
 * the thread that follows the graph acts on it, so that neither waits for a lock of the other.
 */
final class TopicStream implements Followed {
  private final String topic;
  private final Adapter<?, ?> adapter;
  private final RecordDecoder records;
  private final RosNode node;
  private final SessionClock clock;
  private final LinkWatch watch;
  private final Pulse pulse;
  private final Entry<?, ?> entry;
  private Optional<Subscriber> subscriber = Optional.empty();
  private boolean published = true;
  private String told = "";
  private long unreadable;
  private volatile boolean wanted;

  TopicStream(
      String topic,
      Adapter<?, ?> adapter,
      RecordDecoder records,
      RficContext context,
      RosSettings settings,
      RosNode node,
      SessionClock clock,
      LinkWatch watch,
      Pulse pulse) {
    this.topic = topic;
    this.adapter = adapter;
    this.records = records;
    this.node = node;
    this.clock = clock;
    this.watch = watch;
    this.pulse = pulse;
    this.entry = new Entry<>(adapter, context, settings.portName(topic));
  }

  @Override
  public String topic() {
    return topic;
  }

  @Override
  public String type() {
    return adapter.type();
  }

  @Override
  public boolean wanted() {
    return wanted;
  }

  @Override
  public boolean flowing() {
    return subscriber.filter(s -> s.numPublishers() > 0).isPresent();
  }

  @Override
  public void applyDemand() {
    if (wanted && subscriber.isEmpty()) {
      subscriber = Optional.of(entry.subscribe());
    } else if (!wanted) {
      end();
    }
    subscriber.ifPresent(s -> count(s.unreadable()));
  }

  /**
   * A link that is soon made again may look well whenever the graph is looked at; what came by it is lost all the same.
   */
  private void count(Subscriber.Unreadable now) {
    if (now.count() > unreadable) {
      entry.publication.lost(now.count() - unreadable, now.reason());
      unreadable = now.count();
    }
  }

  @Override
  public void published(boolean now) {
    published = now;
    String problem = problem();
    if (!problem.isEmpty() || !told.isEmpty()) {
      entry.publication.failed(problem); // empty takes it back: rare messages may be long in coming
    }
    told = problem;
  }

  @Override
  public String problem() {
    if (!wanted) {
      return "";
    }
    return published ? watch.failure(topic).orElse("") : "nobody publishes " + topic + " any more";
  }

  private void end() {
    if (subscriber.isPresent()) {
      subscriber.get().close();
      subscriber = Optional.empty();
      unreadable = 0;
      watch.forget(topic);
    }
  }

  @Override
  public void close() {
    end();
    entry.publication.close();
  }

  /** Holds the types of one adapter together. */
  private final class Entry<M, D extends Data> {
    private final Adapter<M, D> typed;
    private final Publication<D> publication;

    Entry(Adapter<M, D> typed, RficContext context, String port) {
      this.typed = typed;
      StreamPort<D> stream = new StreamPort<>(port, typed.data(), Arity.MANY, topic + ", " + typed.type());
      this.publication = context.offers().stream(stream, w -> wanted = w);
    }

    Subscriber subscribe() {
      return subscribe(MessageReading.of(typed.form(), records));
    }

    private <R> Subscriber subscribe(MessageReading<R, M> reading) {
      return node.subscriber(topic, reading.codec(), SubscriberOptions.observing(),
          (message, reception) -> received(message, reading.message(), reception));
    }

    private <R> void received(R received, Function<R, M> reading, Reception reception) {
      FrameNames names = clock.names();
      pulse.heard(reception.receiveNanos());
      publication.kept(reception.latched());
      try {
        M message = reading.apply(received);
        Optional<D> value = typed.convert().apply(message, names);
        value.ifPresent(v -> publication.publish(v, clock.stamp(typed.stamp().applyAsLong(message), names),
            reception.receiveNanos(), Optional.of(raw(v, reception))));
      } catch (IllegalArgumentException | ArithmeticException e) {
        publication.lost(1, topic + " from " + reception.callerId() + ": " + e.getMessage());
      }
    }

    private RawMessage raw(D value, Reception reception) {
      return new RawMessage(typed.type(), "ros1", Bytes.wrap(reception.raw()),
          bytes -> value instanceof DynamicRecord r ? Optional.of(r) : records.read(reception.peer(), bytes));
    }
  }
}
