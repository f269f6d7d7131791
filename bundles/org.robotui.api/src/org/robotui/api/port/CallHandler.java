package org.robotui.api.port;

import org.robotui.data.record.DynamicRecord;

/**
 * Answers requests.
 *
 * @param <Q> the type of requests
 * @param <R> the type of replies
 */
@FunctionalInterface
public interface CallHandler<Q, R> {
  /**
   * Handles a request. Called on a worker thread of core and may block until the deadline of the invocation; the thread
   * is interrupted when the caller cancels or the time is over.
   *
   * @param invocation the request
   * @return the reply
   * @throws CallException where it cannot be answered; the message is shown to the user
   * @throws InterruptedException where it was cancelled
   */
  R handle(Invocation<Q> invocation) throws CallException, InterruptedException;

  /**
   * A request under way.
   *
   * @param <Q> the type of requests
   */
  interface Invocation<Q> {
    /**
     * What is asked.
     *
     * @return the request
     */
    Q request();

    /**
     * Until when an answer is awaited, {@link System#nanoTime()}.
     *
     * @return the deadline
     */
    long deadlineNanos();

    /**
     * Tells the caller how far it is.
     *
     * @param fraction 0 to 1, or NaN where unknown
     * @param message a sentence
     */
    void progress(double fraction, String message);

    /**
     * Tells the caller what the robot says on its way.
     *
     * @param record for example the feedback of an action
     */
    void feedback(DynamicRecord record);
  }
}
