package org.robotui.guard;

import java.io.IOException;
import org.robotui.guard.internal.client.Launch;
import org.robotui.guard.internal.client.SharedGuard;

/**
 * One guard for all who share this object: its process runs from the first {@link #open} until the last one is closed.
 * Safe for all threads.
 */
public final class Guards {
  private final SharedGuard shared;

  /** Runs nothing yet. */
  public Guards() {
    this.shared = new SharedGuard(Launch.ofThisMachine());
  }

  /**
   * Starts the guard unless it runs. Waits for its process: not for threads that others wait for.
   *
   * @return to be closed
   * @throws IOException where no process can be started; says why
   */
  public Guard open() throws IOException {
    return shared.open();
  }
}
