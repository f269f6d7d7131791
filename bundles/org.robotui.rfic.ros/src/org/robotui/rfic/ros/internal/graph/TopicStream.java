package org.robotui.rfic.ros.internal.graph;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Bytes;
import org.robotui.data.Data;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.rfic.ros.internal.convert.Adapter;
import org.robotui.rfic.ros.internal.convert.FrameNames;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/**
 * A topic as a stream. The robot is only asked for it while somebody wants it. Core's thread merely notes the demand; the
 * thread that follows the graph acts on it, so that neither waits for a lock of the other.
 */
final class TopicStream implements AutoCloseable {
  private final String topic;
  private final Adapter<?, ?> adapter;
  private final RosNode node;
  private final SessionClock clock;
  private final LinkWatch watch;
  private final Entry<?, ?> entry;
  private Optional<Subscriber> subscriber = Optional.empty();
  private boolean published = true;
  private volatile boolean wanted;

  TopicStream(
      String topic,
      Adapter<?, ?> adapter,
      RficContext context,
      RosSettings settings,
      RosNode node,
      SessionClock clock,
      LinkWatch watch) {
    this.topic = topic;
    this.adapter = adapter;
    this.node = node;
    this.clock = clock;
    this.watch = watch;
    this.entry = new Entry<>(adapter, context, settings.portName(topic));
  }

  String topic() {
    return topic;
  }

  String type() {
    return adapter.type();
  }

  boolean wanted() {
    return wanted;
  }

  boolean flowing() {
    return subscriber.filter(s -> s.numPublishers() > 0).isPresent();
  }

  /** Subscribes or unsubscribes as is wanted now. */
  void applyDemand() {
    if (wanted && subscriber.isEmpty()) {
      subscriber = Optional.of(entry.subscribe());
    } else if (!wanted) {
      end();
    }
  }

  /** Whether somebody publishes the topic now; reports what is missing to whom it may concern. */
  void published(boolean now) {
    published = now;
    String problem = problem();
    if (!problem.isEmpty()) {
      entry.publication.failed(problem);
    }
  }

  String problem() {
    if (!wanted) {
      return "";
    }
    return published ? watch.failure(topic).orElse("") : "nobody publishes " + topic + " any more";
  }

  private void end() {
    if (subscriber.isPresent()) {
      subscriber.get().close();
      subscriber = Optional.empty();
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
      return node.subscriber(topic, typed.codec(), SubscriberOptions.standard(), this::received);
    }

    private void received(M message, Reception reception) {
      FrameNames names = clock.names();
      try {
        Optional<D> value = typed.convert().apply(message, names);
        value.ifPresent(v -> publication.publish(v, clock.stamp(typed.stamp().applyAsLong(message), names),
            reception.receiveNanos(), Optional.of(raw(reception))));
      } catch (IllegalArgumentException | ArithmeticException e) {
        publication.lost(1, topic + " from " + reception.callerId() + ": " + e.getMessage());
      }
    }

    private RawMessage raw(Reception reception) {
      return new RawMessage(typed.type(), "ros1", Bytes.wrap(reception.raw()));
    }
  }
}
