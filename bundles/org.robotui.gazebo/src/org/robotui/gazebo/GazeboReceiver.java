package org.robotui.gazebo;

import java.nio.ByteBuffer;

/** Takes messages of a topic. */
@FunctionalInterface
public interface GazeboReceiver {

  /**
   * A message has come.
   *
   * @param sender the address of the process that published it
   * @param payload the message; nobody writes to it again
   * @param receivedNanos when it was received, by {@link System#nanoTime()}
   */
  void received(String sender, ByteBuffer payload, long receivedNanos);
}
