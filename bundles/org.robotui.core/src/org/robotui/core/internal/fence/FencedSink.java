package org.robotui.core.internal.fence;

import java.util.function.Supplier;
import org.robotui.api.port.CommandSink;
import org.robotui.data.Data;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A foreign sink that only ever answers: what it throws is a refusal that names its origin, so that the sender's thread
 * lives on and can still send a stop.
 *
 * @param <T> the commands
 * @param sink the foreign one
 * @param origin names bundle and class
 */
public record FencedSink<T extends Data>(CommandSink<T> sink, Supplier<String> origin) implements CommandSink<T> {
  private static final Logger LOG = LoggerFactory.getLogger(FencedSink.class);

  @Override
  public Sent send(T command) {
    return answered(() -> sink.send(command));
  }

  @Override
  public Sent stop(T zero, boolean ours) {
    return answered(() -> sink.stop(zero, ours));
  }

  private Sent answered(Supplier<Sent> call) {
    try {
      return call.get();
    } catch (RuntimeException | Error e) { // foreign code may throw anything
      Thrown.log(LOG, "A robot interface failed to send a command", e);
      return new Sent.Refused("the robot interface failed to send: " + Thrown.text(e) + " (" + origin.get() + ")");
    }
  }
}
