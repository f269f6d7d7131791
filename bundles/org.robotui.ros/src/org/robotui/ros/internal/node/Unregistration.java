package org.robotui.ros.internal.node;

import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Uninterruptibles;
import org.robotui.ros.XmlRpcValue;

/** Tells the master once, beside everything else, that it may forget all of a node. Safe for all threads. */
final class Unregistration {
  private static final int PARALLEL = 4;
  private static final Duration FOR_MASTER = Duration.ofMillis(500);
  /** What is being registered now must not reach the master after the farewell. */
  private static final Duration UNDER_WAY = Duration.ofMillis(200);

  private final NodeContext context;
  private final Registrar registrar;
  private final HostPort master;
  private final AtomicBoolean begun = new AtomicBoolean();
  /** How much the master may know yet. */
  private final AtomicInteger known = new AtomicInteger();
  private final CountDownLatch told = new CountDownLatch(1);
  private final CloseableSet clients = new CloseableSet();
  private volatile boolean over;

  Unregistration(NodeContext context, Registrar registrar, HostPort master) {
    this.context = context;
    this.registrar = registrar;
    this.master = master;
  }

  /** Nothing is registered from now on; says so to the master without waiting for it. */
  void begin() {
    if (!begun.compareAndSet(false, true)) {
      return;
    }
    List<Registration> registrations = registrar.close();
    if (registrations.isEmpty()) {
      told.countDown();
    } else {
      known.set(registrations.size()); // until it begins, which may be too late
      context.start("unregister", () -> tell(registrations));
    }
  }

  private void tell(List<Registration> registrations) {
    try (RosApi api = client()) {
      boolean quiet = registrar.awaitEnd(UNDER_WAY);
      tell(registrations, api);
      if (!quiet && registrar.awaitEnd(FOR_MASTER)) {
        tell(registrations, api); // what was under way may have come last
      }
    } finally {
      told.countDown();
    }
  }

  /**
   * All in one request: a master that is slow, or is left by many nodes at once, has it all the same when our time is
   * over.
   */
  private void tell(List<Registration> registrations, RosApi api) {
    known.set(registrations.size());
    Outcome<Integer> all = api.callAll(registrations.stream().flatMap(r -> r.farewell().stream()).toList());
    if (all instanceof Outcome.Failed && !over) {
      drain(new ConcurrentLinkedQueue<>(registrations), api);
    } else if (all instanceof Outcome.Done) {
      known.set(0);
    }
  }

  private RosApi client() {
    RosApi api = new RosApi(master, "master", FOR_MASTER);
    clients.add(api);
    return api;
  }

  /** For a master that takes one call at a time. */
  private void drain(Queue<Registration> queue, RosApi first) {
    List<RosApi> others = Stream.generate(this::client).limit(Math.min(PARALLEL, queue.size()) - 1L).toList();
    CountDownLatch done = new CountDownLatch(others.size());
    others.forEach(api -> context.start("unregister", () -> {
      try (api) {
        empty(queue, api);
      } finally {
        done.countDown();
      }
    }));
    empty(queue, first);
    await(done);
  }

  private void empty(Queue<Registration> queue, RosApi api) {
    for (Registration next = queue.poll(); next != null; next = queue.poll()) {
      Outcome<XmlRpcValue> outcome = next.unregister(api);
      if (outcome instanceof Outcome.Done || outcome instanceof Outcome.Refused) {
        known.decrementAndGet();
      }
    }
  }

  /** Gives it the rest of its time, and ends it. Answers whether the master forgot all. */
  boolean end() {
    await(told);
    over = true;
    clients.close();
    return known.get() == 0;
  }

  private static void await(CountDownLatch latch) {
    Uninterruptibles.await(System.nanoTime() + FOR_MASTER.toNanos(), nanos -> latch.await(nanos, TimeUnit.NANOSECONDS));
  }
}
