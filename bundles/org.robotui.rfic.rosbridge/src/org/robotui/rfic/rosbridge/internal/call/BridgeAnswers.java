package org.robotui.rfic.rosbridge.internal.call;

import org.robotui.api.port.CallException;
import org.robotui.net.call.Outcome;

/** Turns what a bridge answers into what callers are told. */
final class BridgeAnswers {
  private BridgeAnswers() {}

  /** A question that blocks. */
  @FunctionalInterface
  interface Question<T> {
    Outcome<T> ask() throws InterruptedException;
  }

  static <T> T of(Question<T> question) throws CallException {
    try {
      Outcome<T> outcome = question.ask();
      return outcome.toOptional().orElseThrow(() -> new CallException(outcome.reason()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CallException("was cancelled", e);
    }
  }
}
