package org.robotui.gl.internal.context;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Function;
import org.robotui.gl.internal.gpu.Gpu;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The one thread that calls OpenGL, and its context. It starts with the first task. Where a task fails, the context is
 * made anew and the task is tried again; after some failures in a row there is no OpenGL for a while.
 */
public final class GlThread implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(GlThread.class);
  private static final Runnable END = () -> {};
  private static final int TRIES = 3;
  private static final long PAUSE = Duration.ofSeconds(5).toNanos();
  /** A signal ends the workbench within two seconds, and others need some of them. */
  private static final Duration LAST_PICTURE = Duration.ofSeconds(1);
  private static final String DRIVER =
      "Update the driver of the graphics card, or start with LIBGL_ALWAYS_SOFTWARE=1 to draw by the processor.";

  private final BlockingQueue<Runnable> tasks = new LinkedBlockingQueue<>();
  private final Thread thread = daemon(this::work, "OpenGL");
  /** What is done with a picture, while the next one is drawn. */
  private final ExecutorService receiver = Executors.newSingleThreadExecutor(task -> daemon(task, "OpenGL pictures"));
  private Optional<GlContext> context = Optional.empty();
  private Optional<NoOpenGl> verdict = Optional.empty();
  private long verdictNanos;
  /** On the thread only, as those above. */
  private boolean hooked;
  private boolean started;
  private boolean closed;

  /**
   * Runs something on the thread, after all that was given before.
   *
   * @param task must not throw
   * @return false where it is closed, and the task will not run
   */
  public synchronized boolean execute(Runnable task) {
    if (closed) {
      return false;
    }
    if (!started) {
      started = true;
      thread.start();
    }
    return tasks.add(task);
  }

  private static Thread daemon(Runnable task, String name) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Hands something over to those who wait for it, one after the other and in the order of these calls, on another
   * thread; on this one where it is closed.
   *
   * @param answer must not throw
   */
  public void answer(Runnable answer) {
    try {
      receiver.execute(answer);
    } catch (RejectedExecutionException e) {
      answer.run();
    }
  }

  /**
   * Does something with OpenGL. On the thread only.
   *
   * @param <T> what comes out
   * @param work is called again with a new context where it throws
   * @return what comes out
   * @throws NoOpenGl where there is none
   */
  public <T> T with(Function<Gpu, T> work) throws NoOpenGl {
    if (verdict.isPresent() && System.nanoTime() - verdictNanos < PAUSE) {
      throw verdict.get();
    }
    try {
      T result = tried(work);
      verdict = Optional.empty();
      return result;
    } catch (NoOpenGl e) {
      if (verdict.filter(last -> last.getMessage().equals(e.getMessage())).isEmpty()) {
        LOG.warn("{} {}", e.getMessage(), e.remedy());
      }
      verdict = Optional.of(e);
      verdictNanos = System.nanoTime();
      throw e;
    }
  }

  private <T> T tried(Function<Gpu, T> work) throws NoOpenGl {
    for (int attempt = 1;; attempt++) {
      try {
        return work.apply(current());
      } catch (RuntimeException | Error e) { // errors, too: whoever waits for a picture must be told, and the thread
                                             // must live
        LOG.warn("OpenGL fails, its context is made anew", e);
        dropContext();
        if (attempt == TRIES) {
          throw new NoOpenGl("OpenGL failed " + TRIES + " times: " + e.getMessage() + ".", DRIVER);
        }
      }
    }
  }

  private Gpu current() throws NoOpenGl {
    if (context.isEmpty()) {
      context = Optional.of(GlContext.open());
      if (!hooked) {
        hooked = true;
        GlContext.beforeTheEnd(this::endNow);
      }
    }
    return context.get().gpu();
  }

  /**
   * The context, where there is one. On the thread only.
   *
   * @return none where nothing was drawn yet, or where it was lost
   */
  public Optional<Gpu> present() {
    return context.map(GlContext::gpu);
  }

  /** Destroys the context with all that is in it; the next picture makes another. On the thread only. */
  public void dropContext() {
    context.ifPresent(GlContext::close);
    context = Optional.empty();
  }

  private void work() {
    try {
      for (Runnable task = tasks.take(); task != END; task = tasks.take()) {
        task.run();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      dropContext();
    }
  }

  /** The virtual machine ends. */
  private void endNow() {
    close();
    try {
      awaitEnd(LAST_PICTURE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Ends the thread after the tasks that it has, and frees the context. Returns at once. */
  @Override
  public synchronized void close() {
    closed = true;
    tasks.add(END);
    receiver.shutdown();
  }

  /**
   * Waits for the end, after {@link #close()}.
   *
   * @param most how long at most
   * @return true where it ended
   * @throws InterruptedException where this thread is to end itself
   */
  public boolean awaitEnd(Duration most) throws InterruptedException {
    return !isRunning() || Thread.currentThread() != thread && thread.join(most);
  }

  /** A thread that was not started cannot be waited for. */
  private synchronized boolean isRunning() {
    return started;
  }
}
