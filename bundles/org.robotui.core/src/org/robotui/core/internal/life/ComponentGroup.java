package org.robotui.core.internal.life;

import java.lang.Thread.UncaughtExceptionHandler;

/** The threads of one component: those of its factory, and those that they started by themselves. */
final class ComponentGroup extends ThreadGroup {
  private final UncaughtExceptionHandler handler;

  /** A group in the one of the calling thread; the handler is told of threads that threw. */
  ComponentGroup(String name, UncaughtExceptionHandler handler) {
    super(name);
    this.handler = handler;
  }

  @Override
  public void uncaughtException(Thread thread, Throwable error) {
    handler.uncaughtException(thread, error);
  }
}
