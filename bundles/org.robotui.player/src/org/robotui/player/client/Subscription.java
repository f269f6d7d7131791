package org.robotui.player.client;

/** Keeps a device open, over any loss of the link, until it is closed. */
@FunctionalInterface
public interface Subscription extends AutoCloseable {

  /**
   * Ends it; the server is told when it was the last of this client for its device. A listener's call may still end
   * after it.
   */
  @Override
  void close();
}
