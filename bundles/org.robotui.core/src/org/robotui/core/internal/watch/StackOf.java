package org.robotui.core.internal.watch;

/** What a thread was doing, in the form that logs take. Never thrown. */
final class StackOf extends Throwable {
  private static final long serialVersionUID = 1L;

  StackOf(Thread thread, StackTraceElement[] stack) {
    super("the stack of thread " + thread.getName(), null, false, true);
    setStackTrace(stack);
  }

  @Override
  public synchronized Throwable fillInStackTrace() {
    return this; // its own is of no interest
  }
}
