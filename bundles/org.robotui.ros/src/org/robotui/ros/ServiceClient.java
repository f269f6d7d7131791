package org.robotui.ros;

import java.time.Duration;
import org.robotui.net.call.Outcome;

/**
 * Calls one service. Any thread may use it; a persistent client makes its calls one after the other.
 *
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
public interface ServiceClient<Q, R> extends AutoCloseable {

  /**
   * Calls the service and waits for the answer.
   *
   * @param request the request
   * @param timeout for the whole call, with finding and reaching the server
   * @return the response, or why there is none
   */
  Outcome<R> call(Q request, Duration timeout);

  /** Closes the connection; a running call fails. */
  @Override
  void close();
}
