package org.robotui.ros2;

import java.time.Duration;
import java.util.concurrent.CompletionStage;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.name.Ros2Name;

/**
 * Calls one service. Any thread may use it, also for several calls at once.
 *
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
public interface Ros2ServiceClient<Q, R> extends AutoCloseable {

  /**
   * The service.
   *
   * @return its whole name
   */
  Ros2Name name();

  /**
   * Whether a server hears requests and its replies are heard.
   *
   * @return as of now
   */
  boolean ready();

  /**
   * Waits until there is a server.
   *
   * @param patience how long at most
   * @return whether there is one
   */
  boolean awaitServer(Duration patience);

  /**
   * Waits for a server, calls the service and waits for the answer.
   *
   * @param request the request
   * @param timeout for all of it
   * @return the response, or why there is none
   */
  Outcome<R> call(Q request, Duration timeout);

  /**
   * Calls the service without waiting. Nobody says that a server is gone: whoever waits says how long.
   *
   * @param request the request
   * @return completes on the receiving thread with the response, or with why there is none, as when the client is
   * closed
   */
  CompletionStage<Outcome<R>> send(Q request);

  /** Takes it back from the network; calls that wait fail. */
  @Override
  void close();
}
