package org.robotui.rfic.ros2.internal.graph;

import java.util.Optional;
import java.util.concurrent.ThreadFactory;

/**
 * Makes threads that belong to no robot interface: those of a participant that several share, which goes on when the
 * one that came first is closed. A thread is otherwise in the group of the one that makes it, and ended with it.
 */
final class OutlivingThreads implements ThreadFactory {
  @Override
  public Thread newThread(Runnable work) {
    return Thread.ofPlatform().group(outermost()).daemon().name("ros2").unstarted(work);
  }

  private static ThreadGroup outermost() {
    ThreadGroup group = Thread.currentThread().getThreadGroup();
    for (Optional<ThreadGroup> around = around(group); around.isPresent(); around = around(group)) {
      group = around.get();
    }
    return group;
  }

  private static Optional<ThreadGroup> around(ThreadGroup group) {
    return Optional.ofNullable(group.getParent());
  }
}
