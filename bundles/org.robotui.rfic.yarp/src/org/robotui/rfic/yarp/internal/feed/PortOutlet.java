package org.robotui.rfic.yarp.internal.feed;

import java.util.Optional;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.yarp.bottle.Bottle;

/**
 * A stream that is made of what a port says.
 *
 * @param <D> what is made
 */
final class PortOutlet<D extends Data> implements AutoCloseable {
  /**
   * Makes data of a message, on the reading thread; nothing where there is nothing to say yet. What it refuses by an
   * {@link IllegalArgumentException} is told to whoever looks.
   *
   * @param <D> the data
   */
  interface Making<D> {
    Optional<D> of(Bottle message, Optional<Stamp> stamp);
  }

  private final Publication<D> publication;
  private final Making<D> making;
  private volatile boolean demanded;
  private volatile boolean failing;

  PortOutlet(Wires wires, String port, Class<D> type, String help, Making<D> making) {
    this.making = making;
    this.publication =
        wires.context().offers().stream(new StreamPort<>(port, type, Arity.MANY, help), now -> demanded = now);
  }

  boolean demanded() {
    return demanded;
  }

  void take(Bottle message, Optional<Stamp> stamp, long now, RawMessage raw) {
    try {
      Optional<D> value = making.of(message, stamp);
      if (demanded && value.isPresent()) {
        failing = false;
        publication.publish(value.get(), stamp, now, Optional.of(raw));
      }
    } catch (IllegalArgumentException e) {
      publication.lost(1, raw.origin().sender() + ": " + e.getMessage());
    }
  }

  void publish(D value, Optional<Stamp> stamp) {
    publication.publish(value, stamp);
  }

  void lost(String reason) {
    publication.lost(1, reason);
  }

  /** Says why nothing comes, or by an empty reason that it does. */
  void failed(String reason) {
    if (failing || !reason.isEmpty()) {
      failing = !reason.isEmpty();
      publication.failed(reason);
    }
  }

  @Override
  public void close() {
    publication.close();
  }
}
