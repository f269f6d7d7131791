package org.robotui.rosbridge;

import java.util.Map;
import java.util.concurrent.CompletionStage;

/** Answers the calls of a service that a client offers. Called on a thread of the link; must not block. */
@FunctionalInterface
public interface BridgeResponder {

  /**
   * Answers a call.
   *
   * @param arguments the fields of the request by name
   * @return completes with the answer; never completes exceptionally
   */
  CompletionStage<Answer> answer(Map<String, Object> arguments);

  /**
   * An answer.
   *
   * @param result whether the service was carried out
   * @param values the fields of the response by name; bridges of some versions look at them alone
   */
  record Answer(boolean result, Map<String, Object> values) {}

  /** A service that is offered. */
  interface Offered extends AutoCloseable {
    /** Offers it no longer. */
    @Override
    void close();
  }
}
