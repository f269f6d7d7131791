package org.robotui.rfic.foxglove.internal.call;

import java.time.Duration;
import org.robotui.api.port.CallException;
import org.robotui.net.call.Outcome;

/** Turns what a server answers into what callers are told. */
final class Answers {
  static final Duration PATIENCE = Duration.ofSeconds(3);

  private Answers() {}

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
