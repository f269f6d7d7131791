package org.robotui.bridge.internal.far;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;

/**
 * A call under way whose outcome is told otherwise.
 *
 * @param inner the call
 * @param outcome the outcome; never completes exceptionally
 */
public record MappedCall(Call<?> inner, CompletionStage<CallOutcome<ActionReply>> outcome)
    implements Call<ActionReply> {

  /** Tells the outcome by a function, which is called once. */
  <R> MappedCall(Call<R> inner, Function<CallOutcome<?>, CallOutcome<ActionReply>> told) {
    this(inner, inner.outcome().thenApply(told));
  }

  /** Tells the outcome of such a call otherwise, by a function that is called once. */
  public static Call<ActionReply> of(Call<ActionReply> inner,
      Function<CallOutcome<ActionReply>, CallOutcome<ActionReply>> told) {
    return new MappedCall(inner, inner.outcome().thenApply(told));
  }

  /** A call that never began. */
  public static Call<ActionReply> failed(String reason) {
    CompletionStage<CallOutcome<ActionReply>> ended =
        CompletableFuture.completedStage(new CallOutcome.Failed<>(reason));
    return new Call<>() {
      @Override
      public CompletionStage<CallOutcome<ActionReply>> outcome() {
        return ended;
      }

      @Override
      public void cancel() {
        // it has ended already
      }
    };
  }

  @Override
  public void cancel() {
    inner.cancel();
  }
}
