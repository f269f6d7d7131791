package org.robotui.ros.internal.node;

import java.time.Duration;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Ends a node in bounded time: the master hears of it while everything else closes; then the threads are waited for.
 */
record NodeShutdown(NodeContext context, Unregistration leaving) {

  private static final Logger LOG = LoggerFactory.getLogger(NodeShutdown.class);
  private static final Duration FOR_ALL = Duration.ofMillis(900);

  /** Answers whether the master forgot all of it. */
  boolean run(List<Runnable> parts, RosApi used) {
    long start = System.nanoTime();
    leaving.begin();
    parts.forEach(Runnable::run);
    boolean forgotten = leaving.end();
    used.close();
    if (!context.workers().join(start + FOR_ALL.toNanos())) {
      LOG.warn("{}: threads still run after close", context.name());
    }
    return forgotten;
  }
}
