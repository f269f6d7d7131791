package org.robotui.core.internal.life;

import java.util.concurrent.ThreadFactory;

/**
 * Makes threads that work for everybody. They are in the group of the thread that made this factory, though the thread
 * of a component may be the first that needs them: they must not be interrupted or counted as its own when it ends.
 *
 * @param name of the threads
 * @param group theirs
 */
public record SharedThreads(String name, ThreadGroup group) implements ThreadFactory {

  /**
   * To be called by no component.
   *
   * @param name of the threads
   */
  public SharedThreads(String name) {
    this(name, Thread.currentThread().getThreadGroup());
  }

  @Override
  public Thread newThread(Runnable work) {
    return Thread.ofPlatform().group(group).daemon().name(name).unstarted(work);
  }
}
