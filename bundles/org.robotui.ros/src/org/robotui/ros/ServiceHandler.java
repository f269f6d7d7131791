package org.robotui.ros;

/**
 * Answers calls of a service.
 *
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
@FunctionalInterface
public interface ServiceHandler<Q, R> {

  /**
   * Answers one call. Called on the thread of the client's connection, several at once if there are several clients;
   * may take its time.
   *
   * @param request the request
   * @param callerId the client's node name
   * @return the response
   * @throws ServiceException to refuse the call; the message is sent to the client
   */
  R handle(Q request, String callerId) throws ServiceException;
}
