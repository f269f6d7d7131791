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
    Queue<Registration> queue = new ConcurrentLinkedQueue<>(registrations);
    int workers = Math.min(PARALLEL, queue.size());
    CountDownLatch done = new CountDownLatch(workers);
    for (int i = 0; i < workers; i++) {
      RosApi client = new RosApi(master, "master", FOR_MASTER);
      clients.add(client);
      context.start("unregister", () -> drain(queue, client, known, done));
    }
    return done;
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
