package org.robotui.api.session;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;

/** What is closed at the end of one session, the latest first. For the thread of the robot interface. */
public final class SessionScope {
  private final Deque<Runnable> closers = new ArrayDeque<>();

  SessionScope() {}

  /**
   * Keeps a resource until the session has been closed.
   *
   * @param resource what the session needs
   * @param close closes it
   * @param <T> its type
   * @return the resource
   */
  public <T> T closing(T resource, Consumer<? super T> close) {
    closers.push(() -> close.accept(resource));
    return resource;
  }

  /** Closes all, also where one of them throws. */
  void close() {
    while (!closers.isEmpty()) {
      try {
        closers.pop().run();
      } finally {
        close();
      }
    }
  }
}
