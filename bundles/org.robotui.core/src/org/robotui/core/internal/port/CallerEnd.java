package org.robotui.core.internal.port;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller;

/** A view's end of a call port. Where it takes many connections, the first in the order of matching is asked. */
public final class CallerEnd<Q, R> implements Caller<Q, R> {
  private record Target<Q, R>(Optional<CallTarget<Q, R>> first, String reason) {}

  private final Executor core;
  private volatile Target<Q, R> target = new Target<>(Optional.empty(), "not matched yet");

  /** An end that asks nobody. */
  public CallerEnd(Executor core) {
    this.core = core;
  }

  /** Connects it. */
  public void connect(Optional<CallTarget<Q, R>> first, String reason) {
    target = new Target<>(first, reason);
  }

  @Override
  public Call<R> call(Q request, Duration timeout, Progress progress) {
    Target<Q, R> now = target;
    return now.first().map(t -> t.call(request, timeout, progress)).orElseGet(() -> failed(now.reason()));
  }

  private Call<R> failed(String reason) {
    CompletableFuture<CallOutcome<R>> outcome = new CompletableFuture<>();
    core.execute(() -> outcome.complete(new CallOutcome.Failed<>(reason)));
    return new Call<>() {
      @Override
      public CompletionStage<CallOutcome<R>> outcome() {
        return outcome.minimalCompletionStage();
      }

      @Override
      public void cancel() {
        // it has ended already
      }
    };
  }
}
