package org.robotui.core.internal.fence;

import java.util.function.Supplier;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A foreign handler of calls: what it throws fails the call at once, with its origin, instead of leaving it to its
 * time-out.
 *
 * @param <Q> requests
 * @param <R> replies
 * @param handler the foreign one
 * @param origin names bundle and class
 */
public record FencedHandler<Q, R>(CallHandler<Q, R> handler, Supplier<String> origin) implements CallHandler<Q, R> {
  private static final Logger LOG = LoggerFactory.getLogger(FencedHandler.class);

  @Override
  public R handle(Invocation<Q> invocation) throws CallException, InterruptedException {
    try {
      return handler.handle(invocation);
    } catch (RuntimeException | Error e) { // foreign code may throw anything
      Thrown.log(LOG, "The handler of a call failed", e);
      throw new CallException("the robot interface failed: " + Thrown.text(e) + " (" + origin.get() + ")");
    }
  }
}
