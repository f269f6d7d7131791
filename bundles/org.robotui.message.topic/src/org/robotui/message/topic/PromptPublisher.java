package org.robotui.message.topic;

import java.time.Duration;
import java.util.function.IntSupplier;

/**
 * Publishes by a link that sends a message before all that waits, or not at all: nothing of it is kept.
 *
 * @param sending sends a message
 * @param listening how many hear it
 * @param end takes the topic back
 * @param <M> the Java value of a message
 */
public record PromptPublisher<M>(Sending<M> sending, IntSupplier listening, Runnable end)
    implements TopicPublisher<M> {
  private static final Duration PATIENCE = Duration.ofMillis(20);
  private static final Duration STOP = Duration.ofMillis(250);

  /**
   * Sends messages.
   *
   * @param <M> the Java value of a message
   */
  @FunctionalInterface
  public interface Sending<M> {
    /**
     * Sends one now, or not at all.
     *
     * @param message the message
     * @param patience how long to wait for the network to take it
     * @throws InterruptedException if the thread was interrupted
     */
    void send(M message, Duration patience) throws InterruptedException;
  }

  /**
   * Where nothing can be published.
   *
   * @param <M> the Java value of a message
   * @return nobody hears it
   */
  public static <M> PromptPublisher<M> unheard() {
    return new PromptPublisher<>((message, patience) -> {}, () -> 0, () -> {});
  }

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
      sending.send(message, patience);
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
    end.run();
  }
}
