package org.robotui.message.topic.internal;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import org.robotui.message.topic.TopicPublisher;

/**
 * A topic that is advertised with its first message, which waits a moment for its listeners to connect. What comes
 * meanwhile takes its place.
 *
 * @param <M> the Java value of a message
 */
final class PatientTopic<M> implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofMillis(1500);
  private static final Duration GATHERING = Duration.ofMillis(150);

  private final TopicPublisher<M> publisher;
  private final long since = System.nanoTime();
  private Optional<M> waiting = Optional.empty();
  private long connectedAt;
  private long saidAt = since;
  private boolean ready;

  PatientTopic(TopicPublisher<M> publisher) {
    this.publisher = publisher;
  }

  void say(M message) {
    used();
    if (ready) {
      publisher.publish(message);
    } else {
      waiting = Optional.of(message);
    }
  }

  /** Says bytes as they are, once it says messages at once; false where that cannot be. */
  boolean sayRaw(String encoding, ByteBuffer bytes) {
    used();
    return ready && publisher.publishRaw(encoding, bytes);
  }

  /** It is wanted still, though nothing is said. */
  void used() {
    saidAt = System.nanoTime();
  }

  /** Whether a message would be heard, now or as the first one. */
  boolean isHeard() {
    return !ready || publisher.subscribers() > 0;
  }

  Optional<String> obstacle() {
    return publisher.subscribers() > 0 ? Optional.empty() : publisher.obstacle();
  }

  /** The first listener is given some time for the others to come, so that all hear the first message. */
  void tick() {
    long now = System.nanoTime();
    if (!ready && connectedAt == 0 && publisher.subscribers() > 0) {
      connectedAt = now;
    }
    boolean gathered = connectedAt != 0 && now - connectedAt > GATHERING.toNanos();
    if (!ready && (gathered || now - since > PATIENCE.toNanos())) {
      ready = true;
      waiting.ifPresent(publisher::publish);
      waiting = Optional.empty();
    }
  }

  long idleNanos() {
    return System.nanoTime() - saidAt;
  }

  @Override
  public void close() {
    publisher.close();
  }
}
