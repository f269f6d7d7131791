package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.Collection;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.core.internal.fence.Thrown;

/** Calls foreign code with a time limit, on a thread of its own that is given up where it hangs. */
final class Guarded {
  /** It threw or hung; the message is a part of a sentence. */
  static final class GuardException extends Exception {
    private static final long serialVersionUID = 1L;

    GuardException(String message, Throwable cause) {
      super(message, cause);
    }
  }

  private Guarded() {}

  /** Calls; {@code what} names the call in messages, for example {@code start}. */
  static <T> T call(String what, ThreadFactory threads, Duration limit, Callable<T> work)
      throws GuardException, InterruptedException {
    FutureTask<T> task = new FutureTask<>(work);
    threads.newThread(task).start();
    try {
      return task.get(limit.toNanos(), TimeUnit.NANOSECONDS);
    } catch (ExecutionException e) {
      boolean settings = e.getCause() instanceof IllegalArgumentException && e.getCause().getMessage() != null;
      throw new GuardException(settings ? "cannot " + what + ": " + e.getCause().getMessage()
          : "threw " + Thrown.text(e.getCause()) + " in " + what, e.getCause());
    } catch (TimeoutException e) {
      task.cancel(true);
      throw new GuardException("did not return from " + what + " within " + seconds(limit), e);
    }
  }

  /** The same for work without a result. */
  static void run(String what, ThreadFactory threads, Duration limit, Runnable work)
      throws GuardException, InterruptedException {
    call(what, threads, limit, Executors.callable(work));
  }

  /** Runs several pieces of work at once and waits for all of them; they have limits of their own. */
  static void all(ThreadFactory threads, Collection<? extends Runnable> works) throws InterruptedException {
    CountDownLatch done = new CountDownLatch(works.size());
    for (Runnable work : works) {
      threads.newThread(() -> {
        try {
          work.run();
        } finally {
          done.countDown();
        }
      }).start();
    }
    done.await();
  }

  private static String seconds(Duration limit) {
    return String.format(Locale.ROOT, "%.1f s", limit.toMillis() / 1000.0);
  }
}
