package org.robotui.core.internal.port;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.robotui.api.command.Principal;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;

/**
 * A view's end of a call port. The view is told of progress and outcomes on a thread of its own, one after the other:
 * one that blocks then holds up neither the robot interface nor the time-outs of others.
 */
public final class CallerEnd<Q, R> implements Caller<Q, R> {
  private record Targets<Q, R>(List<CallTarget<Q, R>> all, String reason) {}

  private final Principal principal;
  private final Executor answers;
  private volatile Targets<Q, R> targets = new Targets<>(List.of(), "not matched yet");

  /**
   * An end that asks nobody.
   *
   * @param principal as whom the view asks
   * @param answers on which it is told, in order
   */
  public CallerEnd(Principal principal, Executor answers) {
    this.principal = principal;
    this.answers = answers;
  }

  /** Connects it. */
  public void connect(List<CallTarget<Q, R>> all, String reason) {
    targets = new Targets<>(List.copyOf(all), reason);
  }

  @Override
  public List<SourceId> targets() {
    return targets.all().stream().map(CallTarget::id).toList();
  }

  @Override
  public Call<R> call(Q request, Duration timeout, Progress progress) {
    Targets<Q, R> now = targets;
    return call(now.all().stream().findFirst(), now.reason(), request, timeout, progress);
  }

  @Override
  public Call<R> call(SourceId target, Q request, Duration timeout, Progress progress) {
    Optional<CallTarget<Q, R>> wanted = targets.all().stream().filter(t -> t.id().equals(target)).findFirst();
    return call(wanted, target + " is not connected", request, timeout, progress);
  }

  private Call<R> call(
      Optional<CallTarget<Q, R>> target, String otherwise, Q request, Duration timeout, Progress progress) {
    return target.map(t -> told(t.call(principal, request, timeout, told(progress))))
        .orElseGet(() -> EndedCall.failed(otherwise, answers));
  }

  private Call<R> told(Call<R> call) {
    CompletionStage<CallOutcome<R>> outcome = call.outcome().thenApplyAsync(Function.identity(), answers);
    return new Call<>() {
      @Override
      public CompletionStage<CallOutcome<R>> outcome() {
        return outcome;
      }

      @Override
      public void cancel() {
        call.cancel();
      }
    };
  }

  private Progress told(Progress progress) {
    return new Progress() {
      @Override
      public void at(double fraction, String message) {
        answers.execute(() -> progress.at(fraction, message));
      }

      @Override
      public void feedback(DynamicRecord record) {
        answers.execute(() -> progress.feedback(record));
      }
    };
  }
}
