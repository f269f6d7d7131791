package org.robotui.rfic.roboframe.internal.session;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.port.RawDefinition;
import org.robotui.data.array.Bytes;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.roboframe.wire.BrokerMessage;

/**
 * A key that is read for somebody.
 *
 * @param <M> what its values are read as
 */
final class KeyReception<M> implements TopicSubscription {
  private final ReceptionRule<M> rule;
  private final TopicListener<M> listener;
  private final String sender;
  private final Consumer<KeyReception<M>> end;
  private Optional<OfferedKey> offered = Optional.empty(); // guarded by this, as the following
  private Optional<PayloadFormat.Reading<M>> reading = Optional.empty();
  private String failure = "";
  private long next = -1;
  private long dropped;

  KeyReception(ReceptionRule<M> rule, TopicListener<M> listener, String sender, Consumer<KeyReception<M>> end) {
    this.rule = rule;
    this.listener = listener;
    this.sender = sender;
    this.end = end;
  }

  String topic() {
    return rule.topic();
  }

  /** Reads it as the application writes it now. */
  synchronized void follow(RemoteBoard board) {
    offered = board.written(rule.topic()).filter(each -> rule.takes(rule.topic(), each.format()));
    failure = "";
    try {
      reading = offered.map(each -> rule.reading(each.format()));
    } catch (IllegalArgumentException e) {
      reading = Optional.empty();
      failure = rule.topic() + ": " + e.getMessage();
    }
  }

  /** The key that is to be asked for. */
  synchronized Optional<OfferedKey> wanted() {
    return reading.isPresent() ? offered : Optional.empty();
  }

  synchronized String failure() {
    return failure;
  }

  void received(BrokerMessage.Value value, long receivedNanos) {
    Optional<OfferedKey> by;
    Optional<PayloadFormat.Reading<M>> with;
    synchronized (this) {
      by = offered;
      with = reading;
      dropped += next >= 0 && value.count() > next ? value.count() - next : 0;
      next = value.count() + 1;
    }
    if (by.isPresent() && with.isPresent()) {
      read(by.get(), with.get(), value, receivedNanos);
    }
  }

  private void read(OfferedKey by, PayloadFormat.Reading<M> with, BrokerMessage.Value value, long receivedNanos) {
    Arrival arrival = new Arrival(sender, receivedNanos, false, "ros1", value.bytes().asReadOnlyBuffer(),
        by.format()::record, value.key(), () -> Optional.of(new RawDefinition(by.key().type(), "ros1msg",
            Bytes.of(by.key().definition().getBytes(StandardCharsets.UTF_8)))));
    M message;
    try {
      message = with.read(value.bytes().duplicate());
    } catch (IllegalArgumentException e) {
      listener.unreadable(String.valueOf(e.getMessage()), arrival);
      return;
    }
    listener.received(message, arrival);
  }

  @Override
  public synchronized int publishers() {
    return offered.map(each -> each.key().writers().size()).orElse(0);
  }

  /** Of what only the newest counts, nothing is lost where it gives way to a newer one. */
  @Override
  public synchronized Lost lost() {
    return rule.mostWaiting() == 1 || dropped == 0 ? Lost.NONE
        : new Lost(dropped, rule.topic() + ": more came than could be taken");
  }

  @Override
  public void close() {
    end.accept(this);
  }
}
