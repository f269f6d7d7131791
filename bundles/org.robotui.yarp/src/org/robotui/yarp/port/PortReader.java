package org.robotui.yarp.port;

import java.util.Optional;
import org.robotui.yarp.bottle.Bottle;

/** Takes what a port is told, each connection on a thread of its own. */
@FunctionalInterface
public interface PortReader {

  /**
   * Something was said. Whoever said it waits for the return, by tcp.
   *
   * @param arrival what was said
   * @return a reply; empty for ports that are not asked
   */
  Optional<Bottle> received(PortArrival arrival);

  /**
   * Something was said that cannot be read. The connection goes on where its messages are whole.
   *
   * @param from the name of who said it
   * @param reason for a user to read
   */
  default void unreadable(String from, String reason) {
    // nothing
  }

  /**
   * A connection has ended.
   *
   * @param from the name of who was connected
   * @param reason for a user to read
   */
  default void ended(String from, String reason) {
    // nothing
  }
}
