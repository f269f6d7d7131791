package org.robotui.core.internal.port;

import java.time.Duration;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.time.NanoClock;

/** A way to ask a robot, as offered. */
public final class CallTarget<Q, R> implements Offered {
  private final SourceId id;
  private final CallPort<Q, R> port;
  private final CallHandler<Q, R> handler;
  private final CallPool pool;
  private final ScheduledExecutorService timer;
  private final NanoClock clock;
  private final Withdrawal withdrawal;
  private final RateMeter rate;
  private final AtomicBoolean closed = new AtomicBoolean();
  private volatile String problem = "";

  /** Made by the table of offers. */
  public CallTarget(
      SourceId id,
      CallPort<Q, R> port,
      CallHandler<Q, R> handler,
      CallPool pool,
      ScheduledExecutorService timer,
      NanoClock clock,
      Withdrawal withdrawal) {
    this.id = id;
    this.port = port;
    this.handler = handler;
    this.pool = pool;
    this.timer = timer;
    this.clock = clock;
    this.withdrawal = withdrawal;
    this.rate = new RateMeter(clock.nanos());
  }

  /** Starts a call. */
  public Call<R> call(Q request, Duration timeout, Progress progress) {
    rate.mark(clock.nanos());
    RunningCall<Q, R> call = new RunningCall<>(request, clock.nanos() + timeout.toNanos(), progress, timer,
        outcome -> problem = RunningCall.problem(outcome));
    call.start(handler, pool, timeout);
    return call;
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
  public PortStatus status(long now) {
    return new PortStatus(
        id, port.kind(), port.typeName(), false, rate.count(), rate.rateHz(now), Double.NaN, false, 0, problem, "");
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      withdrawal.withdrawn(this);
    }
  }
}
