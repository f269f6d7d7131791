package org.robotui.roboframe.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.robotui.message.roboframe.ModuleStateStreamable;
import org.robotui.roboframe.board.Blackboard;
import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.roboframe.board.KeyUse;

/** One life of a module, on a thread of its own. */
final class ModuleRunner {
  private static final long SECOND = 1_000_000_000L;

  private final String name;
  private final Supplier<RoboModule> making;
  private final Blackboard blackboard;
  private final BiConsumer<String, Throwable> failing;
  private final List<KeyUse> registrations = new ArrayList<>(); // only on its thread
  private final Semaphore changes = new Semaphore(0);
  private final AtomicLong runs = new AtomicLong();
  private volatile boolean ending;
  private volatile boolean over;
  private volatile Optional<String> failure = Optional.empty();
  private volatile Optional<Long> runningSince = Optional.empty();

  ModuleRunner(String name, Supplier<RoboModule> making, Blackboard blackboard,
      BiConsumer<String, Throwable> failing) {
    this.name = name;
    this.making = making;
    this.blackboard = blackboard;
    this.failing = failing;
  }

  boolean isOver() {
    return over;
  }

  /** All of its life. */
  void live() {
    try {
      RoboModule module = making.get();
      try {
        runningSince = Optional.of(System.nanoTime());
        RunPace pace = module.init(new Channels());
        runningSince = Optional.empty();
        follow(module, pace);
      } finally {
        runningSince = Optional.empty();
        module.cleanUp();
      }
    } catch (InterruptedException e) {
      fail(ending ? Optional.empty() : Optional.of(e));
    } catch (Exception | LinkageError | AssertionError | StackOverflowError | OutOfMemoryError e) {
      fail(Optional.of(e));
    } finally {
      registrations.forEach(KeyUse::close);
      over = true;
    }
  }

  private void fail(Optional<Throwable> cause) {
    cause.ifPresent(e -> {
      failure = Optional.of("stopped by " + e.getClass().getSimpleName() + ": " + e.getMessage());
      failing.accept(name, e);
    });
  }

  private void follow(RoboModule module, RunPace pace) throws Exception {
    long next = System.nanoTime();
    while (!ending) {
      switch (pace) {
        case RunPace.Cyclic cyclic -> next = awaitTurn(next, cyclic.period().toNanos());
        case RunPace.OnChange change -> {
          changes.acquire();
          changes.drainPermits();
        }
      }
      if (!ending) {
        runningSince = Optional.of(System.nanoTime());
        module.run();
        runs.incrementAndGet();
        runningSince = Optional.empty();
      }
    }
  }

  private long awaitTurn(long turn, long period) throws InterruptedException {
    long wait = turn - System.nanoTime();
    if (wait > 0 && changes.tryAcquire(wait, TimeUnit.NANOSECONDS)) {
      changes.drainPermits();
      return ending ? turn : awaitTurn(turn, period);
    }
    return Math.max(turn + period, System.nanoTime());
  }

  /** Lets it end when its present turn is over. */
  void end() {
    ending = true;
    changes.release();
  }

  ModuleStateStreamable state() {
    long busy = runningSince.map(since -> (System.nanoTime() - since) / SECOND).orElse(0L);
    String text = failure.orElseGet(() -> over ? "ended" : busy > 0 ? "runs since " + busy + " s" : "running");
    return new ModuleStateStreamable(name, failure.isPresent(), text, runs.get());
  }

  private final class Channels implements ModuleChannels {
    @Override
    public <T> KeyInput<T> request(ChannelKey<T> key) {
      KeyInput<T> input = new KeyInput<>(key.every(), changes::release);
      registrations.add(blackboard.request(key, name, input::accept));
      return input;
    }

    @Override
    public <T> KeyOutput<T> advertise(ChannelKey<T> key) {
      KeyOutput<T> output = blackboard.advertise(key, name);
      registrations.add(output);
      return output;
    }
  }
}
