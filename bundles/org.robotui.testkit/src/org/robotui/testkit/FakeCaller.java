package org.robotui.testkit;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller;
import org.robotui.api.port.SourceId;

/**
 * A caller whose calls a test ends by hand. Without targets every call fails at once.
 *
 * @param <Q> the type of requests
 * @param <R> the type of replies
 */
public final class FakeCaller<Q, R> implements Caller<Q, R> {
  /**
   * A call that was made.
   *
   * @param <Q> the type of requests
   * @param <R> the type of replies
   * @param target who was asked
   * @param request what was asked
   * @param timeout how long the caller waits
   * @param progress whom to tell how far it is
   * @param end completes the call
   * @param cancelled completes when the caller gives up
   */
  public record Made<Q, R>(SourceId target, Q request, Duration timeout, Progress progress,
      CompletableFuture<CallOutcome<R>> end, CompletableFuture<Boolean> cancelled) implements Call<R> {
    @Override
    public CompletionStage<CallOutcome<R>> outcome() {
      return end;
    }

    @Override
    public void cancel() {
      cancelled.complete(true);
    }
  }

  private final List<SourceId> targets;
  private final List<Made<Q, R>> made = new CopyOnWriteArrayList<>();

  /**
   * Makes a caller.
   *
   * @param targets who can be asked
   */
  public FakeCaller(SourceId... targets) {
    this.targets = List.of(targets);
  }

  /**
   * The calls that were made.
   *
   * @return in order
   */
  public List<Made<Q, R>> made() {
    return List.copyOf(made);
  }

  @Override
  public List<SourceId> targets() {
    return targets;
  }

  @Override
  public Call<R> call(Q request, Duration timeout, Progress progress) {
    return call(targets.isEmpty() ? new SourceId("nobody", "there") : targets.getFirst(), request, timeout, progress);
  }

  @Override
  public Call<R> call(SourceId target, Q request, Duration timeout, Progress progress) {
    Made<Q, R> call =
        new Made<>(target, request, timeout, progress, new CompletableFuture<>(), new CompletableFuture<>());
    made.add(call);
    if (!targets.contains(target)) {
      call.end().complete(new CallOutcome.Failed<>(target + " is not connected"));
    }
    return call;
  }
}
