package org.robotui.foxglove;

import java.nio.ByteBuffer;
import java.time.Duration;
import org.robotui.foxglove.internal.Binary;
import org.robotui.web.WebLink;
import org.robotui.web.WebPayload;

/** A channel that we announced. Safe for all threads. */
public final class ClientChannel implements AutoCloseable {

  private final WebLink link;
  private final int id;
  private final Runnable end;
  private volatile boolean closed;

  ClientChannel(WebLink link, int id, Runnable end) {
    this.link = link;
    this.id = id;
    this.end = end;
  }

  /**
   * Publishes before all that waits, or not at all.
   *
   * @param payload in the encoding of the channel
   * @param patience how long to wait for the network to take it
   * @return whether it is on its way; if not, it never will be
   * @throws InterruptedException if the thread was interrupted
   */
  public boolean publish(ByteBuffer payload, Duration patience) throws InterruptedException {
    return !closed && link.command(new WebPayload.Binary(Binary.publish(id, payload)), patience);
  }

  /** Takes it back. */
  @Override
  public void close() {
    closed = true;
    end.run();
  }
}
