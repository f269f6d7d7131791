package org.robotui.api.port;

/**
 * How a call ended.
 *
 * @param <R> the type of replies
 */
public sealed interface CallOutcome<R> {
  /**
   * With a reply.
   *
   * @param <R> the type of replies
   * @param reply the reply
   */
  record Replied<R>(R reply) implements CallOutcome<R> {}

  /**
   * Without one.
   *
   * @param <R> the type of replies
   * @param reason a sentence for users
   */
  record Failed<R>(String reason) implements CallOutcome<R> {}

  /**
   * Not in time.
   *
   * @param <R> the type of replies
   */
  record TimedOut<R>() implements CallOutcome<R> {}

  /**
   * The caller gave up.
   *
   * @param <R> the type of replies
   */
  record Cancelled<R>() implements CallOutcome<R> {}
}
