package org.robotui.core.internal.port;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import org.robotui.api.command.Principal;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RateMeter;
import org.robotui.core.internal.time.NanoClock;

/** A way to ask a robot, as offered. */
public final class CallTarget<Q, R> implements Offered {
  private static final Duration GRACE = Duration.ofSeconds(3);

  private final SourceId id;
  private final CallPort<Q, R> port;
  private final CallHandler<Q, R> handler;
  private final CallPool pool;
  private final Function<Principal, Optional<String>> guard;
  private final ScheduledExecutorService timer;
  private final NanoClock clock;
  private final Withdrawal withdrawal;
  private final RateMeter rate;
  private final Set<RunningCall<Q, R>> open = ConcurrentHashMap.newKeySet();
  private final AtomicBoolean closed = new AtomicBoolean();
  private volatile String problem = "";

  /** Made by the table of offers. */
  public CallTarget(
      SourceId id,
      CallPort<Q, R> port,
      CallHandler<Q, R> handler,
      CallPool pool,
      Function<Principal, Optional<String>> guard,
      ScheduledExecutorService timer,
      NanoClock clock,
      Withdrawal withdrawal) {
    this.id = id;
    this.port = port;
    this.handler = handler;
    this.pool = pool;
    this.guard = guard;
    this.timer = timer;
    this.clock = clock;
    this.withdrawal = withdrawal;
    this.rate = new RateMeter(clock.nanos());
  }

  /** Starts a call of somebody who may have to be allowed to command the robot. */
  public Call<R> call(Principal principal, Q request, Duration timeout, Progress progress) {
    Optional<String> refused = port.guarded() ? guard.apply(principal) : Optional.empty();
    return refused.<Call<R>>map(reason -> EndedCall.failed(reason, timer))
        .orElseGet(() -> start(request, timeout, progress));
  }

  /** Starts a call that nothing may hold up: that of the stop. */
  public Call<R> urgentCall(Q request, Duration timeout) {
    RunningCall<Q, R> call = running(request, timeout, Progress.IGNORED);
    call.start(handler, pool::urgent, timeout);
    return call;
  }

  /** Cancels what is under way and commands the robot. */
  public void cancelGuarded() {
    if (port.guarded()) {
      open.forEach(RunningCall::cancel);
    }
  }

  private Call<R> start(Q request, Duration timeout, Progress progress) {
    RunningCall<Q, R> call = running(request, timeout, progress);
    open.add(call);
    call.outcome().thenAccept(o -> open.remove(call));
    call.start(handler, pool::submit, timeout);
    return call;
  }

  private RunningCall<Q, R> running(Q request, Duration timeout, Progress progress) {
    rate.mark(clock.nanos());
    return new RunningCall<>(request, clock.nanos() + timeout.toNanos(), progress, timer,
        port.guarded() ? GRACE : Duration.ZERO, outcome -> problem = RunningCall.problem(outcome));
  }

  @Override
  public SourceId id() {
    return id;
  }

  @Override
  public CallPort<Q, R> port() {
    return port;
  }

  @Override
  public PortStatus status(NanoClock moment) {
    return new PortStatus(
        id, port.kind(), port.typeName(), false, rate.count(), rate.rateHz(moment.nanos()), Double.NaN, false, 0,
        problem, "");
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      withdrawal.withdrawn(this);
    }
  }
}
