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
}
