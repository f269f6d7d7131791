package org.robotui.api;

import java.io.IOException;
import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.robotui.api.link.LinkState;

/**
 * The one thread of a robot interface that attaches to something, follows it, and attaches again some time after that
 * has ended. It tells the link of every end. What a connection throws beyond {@link IOException} ends the thread, which
 * core reports.
 */
public final class RficWorker {
  /** One connection from its beginning to its end. */
  @FunctionalInterface
  public interface Connection {
    /**
     * Connects and follows, on the worker's thread.
     *
     * @param over whether the robot interface was closed
     * @return why it ended, for users
     * @throws IOException where it cannot connect, with the reason for users
     * @throws InterruptedException where the robot interface was closed
     */
    String follow(BooleanSupplier over) throws IOException, InterruptedException;
  }

  private final RficContext context;
  private final Duration retry;
  private final Connection connection;
  private final Thread thread;
  private volatile boolean closed;

  /**
   * A worker at rest.
   *
   * @param context makes its thread and hears of its link
   * @param retry how long after an end it connects again
   * @param connection connects
   */
  public RficWorker(RficContext context, Duration retry, Connection connection) {
    this.context = context;
    this.retry = retry;
    this.connection = connection;
    this.thread = context.threads().newThread(this::run);
  }

  /**
   * Begins.
   *
   * @param peer to whom it connects
   */
  public void start(String peer) {
    context.link().report(new LinkState.Connecting(peer));
    thread.start();
  }

  private void run() {
    try {
      while (!closed) {
        String reason = end();
        if (!closed) {
          context.link().report(new LinkState.Failed(reason, retry));
        }
        Thread.sleep(retry);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // closed
    }
  }

  private String end() throws InterruptedException {
    try {
      return connection.follow(() -> closed);
    } catch (IOException e) {
      return String.valueOf(e.getMessage());
    }
  }

  /** Tells the thread to end. */
  public void stop() {
    closed = true;
    thread.interrupt();
  }

  /**
   * Waits for its end, no shorter where the caller is interrupted: it may close because of that, and must leave nothing
   * behind.
   *
   * @param patience at most so long
   * @return whether it has ended, or never began
   */
  public boolean join(Duration patience) {
    return join(thread, System.nanoTime() + patience.toNanos());
  }

  /**
   * Waits for the end of a thread, no shorter where the caller is interrupted.
   *
   * @param thread begun or not
   * @param deadline a time of {@link System#nanoTime}
   * @return whether it has ended, or never began
   */
  public static boolean join(Thread thread, long deadline) {
    boolean interrupted = false;
    long left = deadline - System.nanoTime();
    while (thread.isAlive() && left > 0) {
      try {
        thread.join(Duration.ofNanos(left));
      } catch (InterruptedException e) {
        interrupted = true;
      }
      left = deadline - System.nanoTime();
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    return !thread.isAlive();
  }
}
