package org.robotui.message.topic.internal;

import java.util.Optional;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.FrameNames;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.HistoryConversion;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;

/**
 * A topic as a stream. The robot is only asked for it while somebody wants it. Core's thread merely notes the demand;
 * the thread that follows the graph acts on it, so that neither waits for a lock of the other.
 */
final class TopicStream implements Followed {
  private final String topic;
  private final Adapter<?, ?> adapter;
  private final TopicScope scope;
  private final Entry<?, ?> entry;
  private Optional<TopicSubscription> subscription = Optional.empty();
  private boolean published = true;
  private String told = "";
  private long lost;
  private volatile boolean wanted;

  TopicStream(String topic, Adapter<?, ?> adapter, TopicScope scope) {
    this.topic = topic;
    this.adapter = adapter;
    this.scope = scope;
    this.entry = new Entry<>(adapter);
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
    return subscription.filter(s -> s.publishers() > 0).isPresent();
  }

  @Override
  public void applyDemand() {
    if (wanted && subscription.isEmpty()) {
      subscription = Optional.of(entry.subscribe());
    } else if (!wanted) {
      end();
    }
    subscription.ifPresent(s -> count(s.lost()));
  }

  /**
   * A link that is soon made again may look well whenever the graph is looked at; what came by it is lost all the same.
   */
  private void count(TopicSubscription.Lost now) {
    if (now.count() > lost) {
      entry.publication.lost(now.count() - lost, now.reason());
      lost = now.count();
    }
  }

  @Override
  public void published(boolean now) {
    published = now;
    entry.publication.delivery(scope.client().delivery(topic));
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
    return published ? scope.client().failure(topic).orElse("") : "nobody publishes " + topic + " any more";
  }

  private void end() {
    if (subscription.isPresent()) {
      subscription.get().close();
      subscription = Optional.empty();
      lost = 0;
    }
  }

  @Override
  public void close() {
    end();
    entry.publication.close();
  }

  /** Holds the types of one adapter together. */
  private final class Entry<M, D extends Data> implements TopicListener<M> {
    private final Adapter<M, D> typed;
    private final Publication<D> publication;

    Entry(Adapter<M, D> typed) {
      this.typed = typed;
      String port = scope.settings().portName(topic);
      StreamPort<D> stream = new StreamPort<>(port, typed.data(), Arity.MANY, topic + ", " + typed.type());
      this.publication = scope.context().offers().stream(stream, w -> wanted = w);
      scope.client().history(port, topic, typed.type(), typed.form(),
          HistoryConversion.of(typed, port, scope.clock()::names))
          .ifPresent(publication::history);
    }

    TopicSubscription subscribe() {
      return scope.client().subscribe(topic, typed.type(), typed.form(), this);
    }

    @Override
    public void received(M message, Arrival arrival) {
      heard(arrival);
      if (isOurs(arrival)) {
        return;
      }
      FrameNames names = scope.clock().names();
      try {
        typed.convert().apply(message, names).ifPresent(value -> publication.publish(value, stamp(message, names),
            arrival.receiveNanos(), Optional.of(arrival.raw(typed.type(), value))));
      } catch (IllegalArgumentException | ArithmeticException e) {
        lost(String.valueOf(e.getMessage()), arrival);
      }
    }

    /** What a bridge brought here is no news of this robot: it would be carried back. */
    private boolean isOurs(Arrival arrival) {
      return scope.relayed().contains(topic) && arrival.sender().equals(scope.client().name());
    }

    private Optional<Stamp> stamp(M message, FrameNames names) {
      return scope.clock().stamp(typed.stamp().applyAsLong(message), names);
    }

    @Override
    public void unreadable(String reason, Arrival arrival) {
      heard(arrival);
      lost(reason, arrival);
    }

    private void heard(Arrival arrival) {
      scope.pulse().heard(arrival.receiveNanos());
      publication.kept(arrival.kept());
    }

    private void lost(String reason, Arrival arrival) {
      TopicIntake.lost(publication, topic, reason, arrival);
    }
  }
}
