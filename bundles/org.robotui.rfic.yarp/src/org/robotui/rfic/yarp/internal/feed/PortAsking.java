package org.robotui.rfic.yarp.internal.feed;

import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;

/** How a port comes to say its messages to ours. Used by the thread that follows; all but {@code there} may block. */
interface PortAsking {
  /** Begins; what the port says of it. */
  Outcome<String> begin(HostPort where);

  /**
   * Whether it still says them.
   *
   * @param connected whether our port knows that it is connected
   * @param silentNanos how long nothing has come of it
   */
  boolean there(HostPort where, boolean connected, long silentNanos);

  /** It says nothing more to ours. */
  void end(HostPort where);
}
