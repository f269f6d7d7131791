package org.robotui.guard.internal.process;

import java.io.IOException;
import java.nio.channels.SelectionKey;

/** What is done with a channel that is ready. Whatever it throws ends it, and it alone. */
interface Handler {
  void ready(SelectionKey key) throws IOException;

  /** Looks at the time ({@link System#nanoTime}). */
  void tick(long now) throws IOException;

  /** Closes its channels; answers nothing more. */
  void close();
}
