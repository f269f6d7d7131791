package org.robotui.ros;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;

/** Makes threads and knows which of them are alive. */
public final class TestThreads implements ThreadFactory {

  private final Set<Thread> made = ConcurrentHashMap.newKeySet();

  @Override
  public Thread newThread(Runnable work) {
    Thread thread = new Thread(work);
    thread.setDaemon(true);
    made.add(thread);
    return thread;
  }

  /** The threads that still run. */
  public List<String> alive() {
    return made.stream().filter(Thread::isAlive).map(Thread::getName).toList();
  }

  /** Fails if a thread is left shortly after all owners were closed. */
  public void assertNoneLeft() {
    Eventually.await("no threads left but there are " + alive(), () -> alive().isEmpty());
  }
}
