package org.robotui.rfic.ros.internal.call;

import org.robotui.api.port.CallException;
import org.robotui.net.call.Outcome;

/** Turns what the client library answers into what callers are told. */
final class Outcomes {
  private Outcomes() {}

  static <T> T value(Outcome<T> outcome) throws CallException {
    return outcome.toOptional().orElseThrow(() -> new CallException(outcome.reason()));
  }
}
