package org.robotui.api.session;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.robotui.api.RficContext;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;

/**
 * A stream that a robot does not say by itself: it is asked again and again while somebody looks, on a thread of its
 * own. Safe for all threads.
 *
 * @param <D> what is made of answers
 */
public final class AskedStream<D extends Data> implements AutoCloseable {
  private static final long AGAIN_MILLIS = 1000;

  /**
   * A connection by which the robot is asked; used by one thread.
   *
   * @param <D> what is made of answers
   */
  public interface Source<D> extends Closeable {

    /**
     * Asks; may block for a second or two.
     *
     * @return empty where there is nothing to say
     * @throws IOException where no answer comes, with a reason for users; another connection is made after a second
     * @throws IllegalArgumentException where nothing can be made of the answer, with a reason for users
     */
    Optional<D> ask() throws IOException;
  }

  /**
   * Makes connections.
   *
   * @param <D> what is made of answers
   */
  @FunctionalInterface
  public interface Opening<D> {

    /**
     * Connects; may block for a second or two.
     *
     * @return closed by whoever asks
     * @throws IOException with a reason for users
     */
    Source<D> open() throws IOException;
  }

  private final String name;
  private final Duration pace;
  private final BiConsumer<String, Runnable> threads;
  private final Opening<D> opening;
  private final Publication<D> publication;
  private boolean demanded; // guarded by this, as the following
  private boolean running;
  private boolean closed;

  /**
   * Offers the stream at once.
   *
   * @param context where it is offered
   * @param port the stream
   * @param pace how long to wait after an answer
   * @param threads starts its thread, which has a name
   * @param opening connects to the robot
   */
  public AskedStream(RficContext context, StreamPort<D> port, Duration pace, BiConsumer<String, Runnable> threads,
      Opening<D> opening) {
    this.name = port.name();
    this.pace = pace;
    this.threads = threads;
    this.opening = opening;
    this.publication = context.offers().stream(port, this::demand);
  }

  private synchronized void demand(boolean now) {
    demanded = now;
    notifyAll();
    if (now && !running && !closed) {
      running = true;
      threads.accept("asks for " + name, this::run);
    }
  }

  private void run() {
    try {
      while (goesOn()) {
        try (Source<D> source = opening.open()) {
          talk(source);
        } catch (IOException e) {
          publication.failed(String.valueOf(e.getMessage()));
        }
        rest(AGAIN_MILLIS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      synchronized (this) {
        running = false;
      }
    }
  }

  /** A thread that ends and a look that begins do not miss each other. */
  private synchronized boolean goesOn() {
    running = running && demanded && !closed;
    return running;
  }

  private void talk(Source<D> source) throws IOException, InterruptedException {
    while (goesOn()) {
      try {
        Optional<D> value = source.ask();
        publication.failed("");
        value.ifPresent(this::publish);
      } catch (IllegalArgumentException e) {
        publication.failed(String.valueOf(e.getMessage()));
      }
      rest(pace.toMillis());
    }
  }

  /**
   * Says something beside what is asked for.
   *
   * @param value goes to whoever looks
   */
  public void publish(D value) {
    publication.publish(value, Optional.empty());
  }

  /**
   * Says why nothing comes.
   *
   * @param reason for users
   */
  public void failed(String reason) {
    publication.failed(reason);
  }

  private synchronized void rest(long millis) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    while (demanded && !closed && System.nanoTime() - end < 0) {
      TimeUnit.NANOSECONDS.timedWait(this, Math.max(1, end - System.nanoTime()));
    }
  }

  /** Withdraws the stream; its thread ends by itself. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    publication.close();
  }
}
