package org.robotui.sim.internal.camera;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Makes pictures on a thread of its own, one at a time: what comes while one is being made is left out. */
public final class PictureWorker implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(PictureWorker.class);

  private final String name;
  private final ExecutorService worker;
  private final AtomicBoolean busy = new AtomicBoolean();

  /** @param name of the thread */
  public PictureWorker(String name) {
    this.name = name;
    worker = Executors.newSingleThreadExecutor(task -> Thread.ofPlatform().name(name).daemon().unstarted(task));
  }

  public void offer(Runnable picture) {
    if (busy.compareAndSet(false, true)) {
      start(picture);
    }
  }

  private void start(Runnable picture) {
    try {
      worker.execute(() -> make(picture));
    } catch (RejectedExecutionException e) {
      LOG.debug("no picture while the {} closes", name);
    }
  }

  private void make(Runnable picture) {
    try {
      picture.run();
    } catch (RuntimeException e) {
      LOG.error("the {} cannot take a picture", name, e);
    } finally {
      busy.set(false);
    }
  }

  @Override
  public void close() {
    worker.shutdownNow();
  }
}
