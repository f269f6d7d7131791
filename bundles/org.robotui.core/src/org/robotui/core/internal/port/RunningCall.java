package org.robotui.core.internal.port;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.core.internal.fence.Thrown;
import org.robotui.data.record.DynamicRecord;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One call under way. It ends once: by its reply, its failure, its time or its caller, whichever is first. */
final class RunningCall<Q, R> implements Call<R>, CallHandler.Invocation<Q> {
  private static final Logger LOG = LoggerFactory.getLogger(RunningCall.class);

  private final Q request;
  private final long deadline;
  private final Progress progress;
  private final ScheduledExecutorService timer;
  private final Consumer<CallOutcome<R>> ending;
  private final CompletableFuture<CallOutcome<R>> outcome = new CompletableFuture<>();
  private final AtomicBoolean over = new AtomicBoolean();
  private final Duration grace;
  private volatile Runnable interrupt = () -> {};

  /**
   * A call that was not started yet; {@code ending} is told how it ends before its caller is. A call that is cancelled
   * is given the grace to say how the robot took it.
   */
  RunningCall(Q request, long deadline, Progress progress, ScheduledExecutorService timer, Duration grace,
      Consumer<CallOutcome<R>> ending) {
    this.ending = ending;
    this.grace = grace;
    this.request = request;
    this.deadline = deadline;
    this.progress = progress;
    this.timer = timer;
  }

  void start(CallHandler<Q, R> handler, Function<Runnable, Future<?>> pool, Duration timeout) {
    try {
      Future<?> work = pool.apply(() -> run(handler));
      Future<?> alarm =
          timer.schedule(() -> end(new CallOutcome.TimedOut<>()), timeout.toNanos(), TimeUnit.NANOSECONDS);
      interrupt = () -> work.cancel(true);
      outcome.whenComplete((result, error) -> {
        work.cancel(true);
        alarm.cancel(false);
      });
    } catch (RejectedExecutionException e) {
      endElsewhere(new CallOutcome.Failed<>("the robot interface has ended, or too many calls are under way"));
    }
  }

  private void run(CallHandler<Q, R> handler) {
    try {
      end(new CallOutcome.Replied<>(handler.handle(this)));
    } catch (CallException e) {
      end(new CallOutcome.Failed<>(e.getMessage()));
    } catch (InterruptedException e) {
      end(new CallOutcome.Cancelled<>());
    } catch (RuntimeException | LinkageError e) {
      LOG.warn("The handler of a call failed", e);
      end(new CallOutcome.Failed<>("the robot interface failed: " + e));
    }
  }

  private void end(CallOutcome<R> how) {
    if (over.compareAndSet(false, true)) {
      ending.accept(how);
      outcome.complete(how);
    }
  }

  /** Ends it on the timer's thread: callers are promised that their dependents never run on their own thread. */
  private void endElsewhere(CallOutcome<R> how) {
    timer.execute(() -> end(how));
  }

  static String problem(CallOutcome<?> outcome) {
    return switch (outcome) {
      case CallOutcome.Failed<?> f -> f.reason();
      case CallOutcome.TimedOut<?> t -> "the last call was not answered in time";
      case CallOutcome.Replied<?> r -> "";
      case CallOutcome.Cancelled<?> c -> "";
    };
  }

  @Override
  public CompletionStage<CallOutcome<R>> outcome() {
    return outcome.minimalCompletionStage();
  }

  @Override
  public void cancel() {
    if (grace.isZero()) {
      endElsewhere(new CallOutcome.Cancelled<>());
    } else {
      interrupt.run();
      timer.schedule(() -> end(new CallOutcome.Cancelled<>()), grace.toNanos(), TimeUnit.NANOSECONDS);
    }
  }

  @Override
  public Q request() {
    return request;
  }

  @Override
  public long deadlineNanos() {
    return deadline;
  }

  @Override
  public void progress(double fraction, String message) {
    tell(() -> progress.at(fraction, message));
  }

  @Override
  public void feedback(DynamicRecord record) {
    tell(() -> progress.feedback(record));
  }

  /** The caller is told on the handler's thread: what it throws must not look like a failure of the robot interface. */
  private void tell(Runnable news) {
    if (!over.get()) {
      try {
        news.run();
      } catch (RuntimeException | Error e) {
        Thrown.log(LOG, "The caller of a call failed when told of its progress", e);
      }
    }
  }
}
