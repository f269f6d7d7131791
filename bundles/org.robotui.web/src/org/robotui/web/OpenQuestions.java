package org.robotui.web;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.net.call.Outcome;

/**
 * Questions whose answers are awaited. Safe for all threads.
 *
 * @param <T> what is answered
 */
public final class OpenQuestions<T> {

  private final Map<String, CompletableFuture<Outcome<T>>> open = new ConcurrentHashMap<>();
  private final AtomicInteger count = new AtomicInteger();
  private volatile Optional<String> over = Optional.empty();

  /** Nobody has asked yet. */
  public OpenQuestions() {
    // questions come with those who ask
  }

  /** Says a question. */
  @FunctionalInterface
  public interface Asking {
    /**
     * Says it.
     *
     * @param id by which it is answered
     * @return whether it is on its way
     */
    boolean ask(int id);
  }

  /**
   * Asks and blocks for the answer.
   *
   * @param of who is asked, or for what; for users
   * @param patience how long to wait
   * @param asking says the question
   * @return the answer, or why there is none
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<T> ask(String of, Duration patience, Asking asking) throws InterruptedException {
    int id = count.incrementAndGet();
    CompletableFuture<Outcome<T>> answer = new CompletableFuture<>();
    open.put(String.valueOf(id), answer);
    over.ifPresent(this::end);
    try {
      if (!answer.isDone() && !asking.ask(id)) {
        return new Outcome.Failed<>(of + " cannot be asked: too much waits to be sent, or the link has ended");
      }
      return answer.get(patience.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return new Outcome.TimedOut<>(of + " has not answered within " + patience.toMillis() + " ms", patience);
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    } finally {
      open.remove(String.valueOf(id));
    }
  }

  /**
   * An answer has come; one that nobody awaits is ignored.
   *
   * @param id of the question
   * @param outcome the answer
   */
  public void answered(String id, Outcome<T> outcome) {
    Optional.ofNullable(open.get(id)).ifPresent(answer -> answer.complete(outcome));
  }

  /**
   * No answer comes any more.
   *
   * @param reason for users
   */
  public void end(String reason) {
    over = Optional.of(reason);
    open.values().forEach(answer -> answer.complete(new Outcome.Failed<>(reason)));
  }
}
