package org.robotui.message.topic;

import org.robotui.api.port.CallException;
import org.robotui.message.SchemaLookup;
import org.robotui.net.call.Outcome;

/** Turns what a client library answers into what callers are told. */
public final class CallOutcomes {
  private CallOutcomes() {}

  /**
   * The answer of a robot.
   *
   * @param outcome how a call ended
   * @param <T> the type of the answer
   * @return the answer
   * @throws CallException where there is none, with the reason
   */
  public static <T> T value(Outcome<T> outcome) throws CallException {
    return outcome.toOptional().orElseThrow(() -> new CallException(outcome.reason()));
  }

  /**
   * A type.
   *
   * @param lookup the answer to the question for it
   * @param <S> its kind
   * @return the type
   * @throws CallException where it is not known, with the reason
   */
  public static <S> S found(SchemaLookup<S> lookup) throws CallException {
    return switch (lookup) {
      case SchemaLookup.Found<S> found -> found.schema();
      case SchemaLookup.Missing<S> missing -> throw new CallException(missing.reason());
    };
  }

  /** Asks a robot, and waits for its answer. */
  @FunctionalInterface
  public interface Question<T> {

    /**
     * Asks.
     *
     * @return how the call ended
     * @throws InterruptedException where the thread shall end meanwhile
     */
    Outcome<T> ask() throws InterruptedException;
  }

  /**
   * The answer of a robot to a question that blocks.
   *
   * @param question is asked
   * @param <T> the type of the answer
   * @return the answer
   * @throws CallException where there is none, with the reason, and where the thread is interrupted
   */
  public static <T> T asked(Question<T> question) throws CallException {
    try {
      return value(question.ask());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CallException("was cancelled", e);
    }
  }
}
