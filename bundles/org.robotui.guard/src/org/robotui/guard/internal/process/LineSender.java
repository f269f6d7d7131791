package org.robotui.guard.internal.process;

import java.io.PrintStream;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;

/**
 * Says lines to the guarded process, on a thread of its own: a process that is stopped reads nothing, and nobody may
 * wait for it.
 */
final class LineSender {
  private static final int MOST = 1000;

  private final BlockingQueue<String> lines = new ArrayBlockingQueue<>(MOST);

  LineSender(PrintStream out) {
    Thread speaker = new Thread(() -> speak(out), "voice");
    speaker.setDaemon(true);
    speaker.start();
  }

  /** Never waits: what is too much is not said. */
  void say(String line) {
    lines.offer(line);
  }

  private void speak(PrintStream out) {
    try {
      while (!out.checkError()) {
        out.print(lines.take() + "\n");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
