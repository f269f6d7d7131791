package org.robotui.core.internal.port;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;

/** A call that never began. */
record EndedCall<R>(CompletionStage<CallOutcome<R>> outcome) implements Call<R> {
  /** Ends on one of core's threads: callers are promised that their dependents never run on their own thread. */
  static <R> Call<R> failed(String reason, Executor core) {
    CompletableFuture<CallOutcome<R>> outcome = new CompletableFuture<>();
    core.execute(() -> outcome.complete(new CallOutcome.Failed<>(reason)));
    return new EndedCall<>(outcome.minimalCompletionStage());
  }

  @Override
  public void cancel() {
    // it has ended already
  }
}
