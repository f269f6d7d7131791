package org.robotui.ros.internal.node;

import java.io.Closeable;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.robotui.ros.Outcome;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.io.Closeables;
import org.robotui.ros.internal.io.HostPort;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Ends a node in bounded time: tells the master while everything else closes, and waits for the threads. */
record NodeShutdown(NodeContext context, List<Registration> registrations, HostPort master) {

  private static final Logger LOG = LoggerFactory.getLogger(NodeShutdown.class);
  private static final int PARALLEL = 4;
  private static final Duration FOR_MASTER = Duration.ofMillis(500);
  private static final Duration FOR_ALL = Duration.ofMillis(900);

  /** Answers whether the master forgot all of it. */
  boolean run(List<Runnable> parts, RosApi used) {
    long start = System.nanoTime();
    List<Closeable> clients = new ArrayList<>();
    AtomicInteger known = new AtomicInteger(registrations.size());
    CountDownLatch told = unregister(clients, known);
    parts.forEach(Runnable::run);
    await(told, start + FOR_MASTER.toNanos());
    clients.forEach(Closeables::quietly);
    used.close();
    if (!context.workers().join(start + FOR_ALL.toNanos())) {
      LOG.warn("{}: threads still run after close", context.name());
    }
    return known.get() == 0;
  }

  private CountDownLatch unregister(List<Closeable> clients, AtomicInteger known) {
    List<RosApi> apis = Stream.generate(() -> new RosApi(master, "master", FOR_MASTER)).limit(Math.min(PARALLEL, registrations.size())).toList();
    clients.addAll(apis);
    CountDownLatch done = new CountDownLatch(apis.size());
    if (!apis.isEmpty()) {
      context.start("unregister", () -> tell(apis, known, done));
    }
    return done;
  }

  /** All in one request: a master that is slow, or is left by many nodes at once, has it all the same when our time is over. */
  private void tell(List<RosApi> apis, AtomicInteger known, CountDownLatch done) {
    Outcome<Integer> told = apis.getFirst().callAll(registrations.stream().flatMap(r -> r.farewell().stream()).toList());
    if (told instanceof Outcome.Failed) {
      Queue<Registration> queue = new ConcurrentLinkedQueue<>(registrations);
      apis.stream().skip(1).forEach(api -> context.start("unregister", () -> drain(queue, api, known, done)));
      drain(queue, apis.getFirst(), known, done);
      return;
    }
    if (told instanceof Outcome.Done) {
      known.set(0);
    }
    apis.forEach(api -> done.countDown());
  }

  private static void drain(Queue<Registration> queue, RosApi client, AtomicInteger known, CountDownLatch done) {
    try (client) {
      for (Registration next = queue.poll(); next != null; next = queue.poll()) {
        Outcome<XmlRpcValue> outcome = next.unregister(client);
        if (outcome instanceof Outcome.Done || outcome instanceof Outcome.Refused) {
          known.decrementAndGet();
        }
      }
    } finally {
      done.countDown();
    }
  }

  private static void await(CountDownLatch latch, long deadline) {
    try {
      latch.await(deadline - System.nanoTime(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
