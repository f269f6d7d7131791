package org.robotui.workbench.internal.display;

import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.host.Host;
import org.robotui.workbench.internal.model.Overview;

/**
 * Looks at the robots on a thread of its own: they may have thousands of ports, and the display thread has none to
 * spare. Called on the display thread.
 */
public final class Overviewer implements AutoCloseable {
  private final Host host;
  private final Executor display;
  private final Runnable news;
  private final ExecutorService worker =
      Executors.newSingleThreadExecutor(Thread.ofPlatform().daemon().name("robotui-overview").factory());
  private final AtomicBoolean pending = new AtomicBoolean();
  private volatile Set<String> shown = Set.of();
  private volatile Overview last = Overview.NOTHING;

  /**
   * Looks at nothing yet.
   *
   * @param host the core
   * @param display runs tasks on the display thread, later
   * @param news runs on the display thread after each look
   */
  public Overviewer(Host host, Executor display, Runnable news) {
    this.host = host;
    this.display = display;
    this.news = news;
  }

  /** Has the robots looked at soon; once for any number of requests before that. */
  public void request(Set<String> names) {
    shown = Set.copyOf(names);
    if (!worker.isShutdown() && pending.compareAndSet(false, true)) {
      worker.execute(this::look);
    }
  }

  /** What was seen last. */
  public Overview last() {
    return last;
  }

  @Override
  public void close() {
    worker.shutdownNow();
  }

  private void look() {
    pending.set(false);
    last = Overview.of(host.ruics(), shown);
    display.execute(news);
  }
}
