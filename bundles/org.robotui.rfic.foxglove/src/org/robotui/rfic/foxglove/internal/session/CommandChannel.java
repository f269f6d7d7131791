package org.robotui.rfic.foxglove.internal.session;

import java.time.Duration;
import java.util.function.IntSupplier;
import org.robotui.foxglove.ClientChannel;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.rfic.foxglove.internal.payload.CommandFormat;

/**
 * A channel of ours for one topic. A message goes out before all that waits, or not at all: nothing of it is kept.
 *
 * @param channel of the server
 * @param writing makes the bytes of messages
 * @param listening how many hear it
 * @param <M> the Java value of a message
 */
record CommandChannel<M>(ClientChannel channel, CommandFormat.Writing<M> writing, IntSupplier listening)
    implements TopicPublisher<M> {
  private static final Duration PATIENCE = Duration.ofMillis(20);
  private static final Duration STOP = Duration.ofMillis(250);

  @Override
  public int subscribers() {
    return listening.getAsInt();
  }

  @Override
  public void publish(M message) {
    send(message, PATIENCE);
  }

  @Override
  public void publishUrgently(M message) {
    send(message, STOP);
  }

  private void send(M message, Duration patience) {
    try {
      channel.publish(writing.write(message), patience);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void awaitSent(Duration patience) {
    // what was published is on its way, or never will be
  }

  @Override
  public void close() {
    channel.close();
  }

  /**
   * Where a server takes nothing.
   *
   * @param <M> the Java value of a message
   */
  record Closed<M>() implements TopicPublisher<M> {
    @Override
    public int subscribers() {
      return 0;
    }

    @Override
    public void publish(M message) {
      // nobody hears it
    }

    @Override
    public void publishUrgently(M message) {
      // nobody hears it
    }

    @Override
    public void awaitSent(Duration patience) {
      // nothing was sent
    }

    @Override
    public void close() {
      // nothing is open
    }
  }
}
