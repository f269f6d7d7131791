package org.robotui.rfic.ros.internal.graph;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import org.robotui.ros.StaleRegistrations;

/**
 * Removes what earlier runs left, one interface at a time: those of a team that ask meanwhile get the same answer, as
 * what fifty killed nodes left would else be looked at fifty times, at once and by the same master. Safe for all
 * threads.
 */
public final class SharedCleanup {
  /** What a sweep found, and when it ended. */
  private record Swept(Path folder, boolean complete, long atNanos) {}

  private final ReentrantLock sweeping = new ReentrantLock();
  private Optional<Swept> last = Optional.empty();

  /** Has not swept. */
  public SharedCleanup() {
    // Folders come with the interfaces that ask.
  }

  /**
   * Sweeps, or waits for the sweep that is under way.
   *
   * @param folder where nodes left their notes
   * @param within no further note is looked at after this time
   * @return whether nothing is left to be tried again
   * @throws IOException if the folder cannot be read
   * @throws InterruptedException where the thread shall end before its turn
   */
  public boolean complete(Path folder, Duration within) throws IOException, InterruptedException {
    long asked = System.nanoTime();
    sweeping.lockInterruptibly();
    try {
      Optional<Swept> since = last.filter(swept -> swept.folder().equals(folder) && swept.atNanos() - asked > 0);
      if (since.isPresent()) {
        return since.get().complete();
      }
      boolean complete = StaleRegistrations.clear(folder, within).complete();
      last = Optional.of(new Swept(folder, complete, System.nanoTime()));
      return complete;
    } finally {
      sweeping.unlock();
    }
  }
}
