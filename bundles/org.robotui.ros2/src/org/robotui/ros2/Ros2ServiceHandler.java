package org.robotui.ros2;

/**
 * Answers calls of a service.
 *
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
@FunctionalInterface
public interface Ros2ServiceHandler<Q, R> {

  /**
   * Answers one call. Called on a thread of the server's own, one call after another; may take its time. ROS 2 has no
   * way to refuse a call: where this throws, nothing is answered, and that is logged.
   *
   * @param request the request
   * @param caller the client's node, or its writer where that is not known
   * @return the response
   */
  R handle(Q request, String caller);
}
