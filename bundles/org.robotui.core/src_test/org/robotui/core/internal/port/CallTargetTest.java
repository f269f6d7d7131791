package org.robotui.core.internal.port;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.support.Samples;
import org.robotui.core.internal.time.NanoClock;

class CallTargetTest {
  private static final CallPort<String, Integer> PORT =
      new CallPort<>("length", String.class, Integer.class, Arity.ONE, "");
  private static final CallPort<String, Integer> GUARDED =
      new CallPort<>("length", String.class, Integer.class, Arity.ONE, "", true);

  private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor();
  private final CallPool pool = new CallPool(Thread.ofPlatform().daemon().factory());
  private Optional<String> refusal = Optional.empty();
  private final CallerEnd<String, Integer> caller = new CallerEnd<>(Samples.YOU, timer);

  @AfterEach
  void end() {
    pool.close();
    timer.shutdownNow();
  }

  private CallTarget<String, Integer> target(CallHandler<String, Integer> handler) {
    return target(PORT, handler);
  }

  private CallTarget<String, Integer> target(CallPort<String, Integer> port, CallHandler<String, Integer> handler) {
    CallTarget<String, Integer> target = new CallTarget<>(
        new SourceId("base", "length"), port, handler, pool, who -> refusal, timer, NanoClock.SYSTEM, o -> {});
    caller.connect(List.of(target), "");
    return target;
  }

  private Call<Integer> call(Duration timeout, Progress progress) {
    return caller.call("four", timeout, progress);
  }

  private static CallOutcome<Integer> outcome(Call<Integer> call) throws Exception {
    return call.outcome().toCompletableFuture().get(5, TimeUnit.SECONDS);
  }

  @Test
  void replyComesWithProgress() throws Exception {
    List<Double> progress = new CopyOnWriteArrayList<>();
    target(i -> {
      i.progress(0.5, "half");
      return i.request().length();
    });
    assertEquals(new CallOutcome.Replied<>(4), outcome(call(Duration.ofSeconds(5), (f, m) -> progress.add(f))));
    assertEquals(List.of(0.5), progress);
  }

  @Test
  void failureIsTheReasonOfTheHandler() throws Exception {
    CallTarget<String, Integer> target = target(i -> {
      throw new CallException("no such service");
    });
    assertEquals(new CallOutcome.Failed<>("no such service"), outcome(call(Duration.ofSeconds(5), Progress.IGNORED)));
    assertEquals("no such service", target.status(NanoClock.SYSTEM).problem());
  }

  @Test
  void brokenHandlerIsAFailureToo() throws Exception {
    target(i -> {
      throw new IllegalStateException("bug");
    });
    CallOutcome<Integer> outcome = outcome(call(Duration.ofSeconds(5), Progress.IGNORED));
    assertTrue(assertInstanceOf(CallOutcome.Failed.class, outcome).reason().contains("bug"));
  }

  @Test
  void timeOutInterruptsTheHandler() throws Exception {
    CountDownLatch interrupted = new CountDownLatch(1);
    target(i -> hang(interrupted));
    assertEquals(new CallOutcome.TimedOut<>(), outcome(call(Duration.ofMillis(30), Progress.IGNORED)));
    assertTrue(interrupted.await(5, TimeUnit.SECONDS));
  }

  @Test
  void cancelInterruptsTheHandler() throws Exception {
    CountDownLatch interrupted = new CountDownLatch(1);
    CountDownLatch started = new CountDownLatch(1);
    target(i -> {
      started.countDown();
      return hang(interrupted);
    });
    Call<Integer> call = call(Duration.ofSeconds(60), Progress.IGNORED);
    assertTrue(started.await(5, TimeUnit.SECONDS));
    call.cancel();
    assertEquals(new CallOutcome.Cancelled<>(), outcome(call));
    assertTrue(interrupted.await(5, TimeUnit.SECONDS));
  }

  @Test
  void unconnectedCallerSaysWhyOnACoreThread() throws Exception {
    caller.connect(List.of(), "nothing answers");
    assertEquals(new CallOutcome.Failed<>("nothing answers"), outcome(call(Duration.ofSeconds(1), Progress.IGNORED)));
  }

  @Test
  void tooManyCallsAreRefusedNotQueuedForEver() throws Exception {
    CountDownLatch interrupted = new CountDownLatch(100);
    target(i -> hang(interrupted));
    List<Call<Integer>> calls = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      calls.add(call(Duration.ofSeconds(60), Progress.IGNORED));
    }
    CallOutcome<Integer> last = outcome(calls.getLast());
    assertTrue(assertInstanceOf(CallOutcome.Failed.class, last).reason().contains("too many calls"));
    calls.forEach(Call::cancel);
  }

  private static Integer hang(CountDownLatch interrupted) throws InterruptedException {
    try {
      new CountDownLatch(1).await();
      return 0;
    } catch (InterruptedException e) {
      interrupted.countDown();
      throw e;
    }
  }

  @Test
  void onlyGuardedCallsAreRefusedToThoseWhoMayNotCommand() throws Exception {
    refusal = Optional.of("nobody has the control; take it first");
    target(i -> 1);
    assertEquals(new CallOutcome.Replied<>(1), outcome(call(Duration.ofSeconds(5), Progress.IGNORED)));
    target(GUARDED, i -> 1);
    assertEquals(new CallOutcome.Failed<>(refusal.get()), outcome(call(Duration.ofSeconds(5), Progress.IGNORED)));
  }

  @Test
  void aStopCancelsGuardedCallsAlone() throws Exception {
    CountDownLatch free = new CountDownLatch(1);
    CallTarget<String, Integer> plain = target(i -> {
      free.await();
      return 1;
    });
    Call<Integer> asking = call(Duration.ofSeconds(5), Progress.IGNORED);
    CallTarget<String, Integer> guarded = target(GUARDED, i -> {
      new CountDownLatch(1).await();
      return 2;
    });
    Call<Integer> moving = call(Duration.ofSeconds(5), Progress.IGNORED);
    List.of(plain, guarded).forEach(CallTarget::cancelGuarded);
    assertEquals(new CallOutcome.Cancelled<>(), outcome(moving));
    free.countDown();
    assertEquals(new CallOutcome.Replied<>(1), outcome(asking));
  }

  @Test
  void anUrgentCallDoesNotWaitForOthers() throws Exception {
    CallTarget<String, Integer> target = target(i -> {
      if (i.request().equals("four")) {
        new CountDownLatch(1).await();
      }
      return i.request().length();
    });
    for (int i = 0; i < 40; i++) {
      call(Duration.ofSeconds(30), Progress.IGNORED);
    }
    assertEquals(new CallOutcome.Replied<>(3), outcome(target.urgentCall("now", Duration.ofSeconds(5))));
  }

  @Test
  void aGuardedCallThatIsCancelledMaySayHowTheRobotTookIt() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    target(GUARDED, i -> {
      begun.countDown();
      try {
        new CountDownLatch(1).await();
      } catch (InterruptedException e) {
        return 7; // the robot has stopped in an orderly way
      }
      return 1;
    });
    Call<Integer> moving = call(Duration.ofSeconds(30), Progress.IGNORED);
    assertTrue(begun.await(5, TimeUnit.SECONDS));
    moving.cancel();
    assertEquals(new CallOutcome.Replied<>(7), outcome(moving));
  }
}
