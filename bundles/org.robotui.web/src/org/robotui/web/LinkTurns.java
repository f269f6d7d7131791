package org.robotui.web;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/** What has to be done again and again while a link lasts. */
public final class LinkTurns {
  private static final Duration TURN = Duration.ofMillis(50);

  private LinkTurns() {}

  /**
   * Takes turns on the calling thread, twenty a second, until somebody ends it.
   *
   * @param ended completes with the reason when the link has ended
   * @param over whether to stop without a reason
   * @param turn does what is due; answers why the link is given up, if it is
   * @return why it ended; none where it was to stop
   * @throws InterruptedException where the thread shall end
   */
  public static Optional<String> take(CompletableFuture<String> ended, BooleanSupplier over,
      Supplier<Optional<String>> turn) throws InterruptedException {
    while (!over.getAsBoolean()) {
      Optional<String> end = turn.get();
      if (end.isPresent()) {
        return end;
      }
      try {
        return Optional.of(ended.get(TURN.toMillis(), TimeUnit.MILLISECONDS));
      } catch (TimeoutException e) {
        // the usual case: it goes on
      } catch (ExecutionException e) {
        throw new IllegalStateException(e);
      }
    }
    return Optional.empty();
  }
}
