package org.robotui.sim.internal.message;

import java.util.function.Function;

/** A topic whose messages are numbered. For one thread. */
public final class Topic<T> {
  private final MessageSink<T> sink;
  private long sequence;

  private Topic(MessageSink<T> sink) {
    this.sink = sink;
  }

  public static <T extends Record> Topic<T> of(MessageNode node, String name, Class<T> type, TopicKind kind) {
    return new Topic<>(node.topic(name, type, kind));
  }

  /** Whether anybody would see a message. */
  boolean isWanted() {
    return sink.isWanted();
  }

  /** Makes a message and sends it, unless nobody would see it. */
  public void publish(long nanos, Function<Stamp, T> message) {
    sequence++;
    if (isWanted()) {
      sink.send(message.apply(new Stamp(sequence, nanos)));
    }
  }
}
