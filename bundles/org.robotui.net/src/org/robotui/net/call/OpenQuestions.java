package org.robotui.net.call;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntPredicate;

/**
 * Questions that wait for their answers, by their references. Safe for all threads.
 *
 * @param <A> an answer
 */
public final class OpenQuestions<A> {

  private final Map<Integer, CompletableFuture<A>> waiting = new ConcurrentHashMap<>();
  private final AtomicInteger references = new AtomicInteger();
  private volatile boolean over;

  /**
   * The next reference.
   *
   * @return from 1
   */
  public int next() {
    return references.updateAndGet(last -> last == Integer.MAX_VALUE ? 1 : last + 1);
  }

  /**
   * Asks and waits, which blocks.
   *
   * @param what is asked, for the reason
   * @param patience how long the answer may take
   * @param sending sends the question of a reference; false where it cannot
   * @return the answer
   * @throws IOException where there is none, with the reason
   */
  public A ask(String what, Duration patience, IntPredicate sending) throws IOException {
    int reference = next();
    CompletableFuture<A> answer = new CompletableFuture<>();
    waiting.put(reference, answer);
    try {
      if (over || !sending.test(reference)) {
        throw new IOException(what + " cannot be asked: the link has ended");
      }
      return answer.get(patience.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      throw new IOException(what + " was not answered within " + patience.toMillis() / 1000.0 + " s", e);
    } catch (ExecutionException e) {
      throw new IOException(what + " was not answered: " + e.getCause().getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException(what + " was given up", e);
    } finally {
      waiting.remove(reference);
    }
  }

  /**
   * An answer has come; one that nobody waits for is dropped.
   *
   * @param reference of the question
   * @param answer to it
   */
  public void answered(int reference, A answer) {
    CompletableFuture<A> asked = waiting.remove(reference);
    if (asked != null) {
      asked.complete(answer);
    }
  }

  /**
   * No more answers come.
   *
   * @param reason for those who wait
   */
  public void fail(String reason) {
    over = true;
    waiting.values().forEach(answer -> answer.completeExceptionally(new IOException(reason)));
  }
}
