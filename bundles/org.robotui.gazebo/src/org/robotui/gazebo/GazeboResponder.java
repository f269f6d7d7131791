package org.robotui.gazebo;

import java.nio.ByteBuffer;
import java.util.Optional;

/** Answers the requests of a service. */
@FunctionalInterface
public interface GazeboResponder {

  /**
   * A request has come. Called on the thread of the sockets, so that it must not block.
   *
   * @param request the request; nobody writes to it again
   * @return the response, or none where the request failed
   */
  Optional<byte[]> answer(ByteBuffer request);
}
