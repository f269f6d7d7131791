package org.robotui.ros2;

import java.util.concurrent.CompletionStage;

/**
 * Answers calls of a service later.
 *
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
@FunctionalInterface
public interface Ros2DeferringHandler<Q, R> {

  /**
   * Takes one call. Called on a thread of the server's own, one call after another.
   *
   * @param request the request
   * @param caller the client's node, or its writer where that is not known
   * @return completes with the response on any thread, which sends it; nothing is answered where it fails
   */
  CompletionStage<R> handle(Q request, String caller);
}
