package org.robotui.api.port;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletionStage;
import org.robotui.data.record.DynamicRecord;

/**
 * The view's end of a call port.
 *
 * @param <Q> the type of requests
 * @param <R> the type of replies
 */
public interface Caller<Q, R> {
  /**
   * Asks. Returns at once; all outcomes, also that nothing is connected, come through the answer.
   *
   * @param request the request
   * @param timeout how long to wait
   * @param progress is told how far it is, on a core thread
   * @return the call under way
   */
  Call<R> call(Q request, Duration timeout, Progress progress);

  /**
   * Who can be asked.
   *
   * @return the connected ports, in the order of matching; {@link #call(Object, Duration, Progress)} asks the first
   */
  List<SourceId> targets();

  /**
   * Asks one of several.
   *
   * @param target one of {@link #targets()}
   * @param request the request
   * @param timeout how long to wait
   * @param progress is told how far it is, on a core thread
   * @return the call under way
   */
  Call<R> call(SourceId target, Q request, Duration timeout, Progress progress);

  /** Is told how far a call is. */
  @FunctionalInterface
  interface Progress {
    /** For callers who do not care. */
    Progress IGNORED = (fraction, message) -> {};

    /**
     * Some progress.
     *
     * @param fraction 0 to 1, or NaN where unknown
     * @param message a sentence
     */
    void at(double fraction, String message);

    /**
     * What the robot says on its way.
     *
     * @param record for example the feedback of an action
     */
    default void feedback(DynamicRecord record) {}
  }

  /**
   * A call under way.
   *
   * @param <R> the type of replies
   */
  interface Call<R> {
    /**
     * The end of the call; never completes exceptionally.
     *
     * @return completes on a core thread
     */
    CompletionStage<CallOutcome<R>> outcome();

    /** Gives up. */
    void cancel();
  }
}
