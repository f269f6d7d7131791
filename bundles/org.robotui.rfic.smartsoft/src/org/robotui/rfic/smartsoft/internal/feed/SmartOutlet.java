package org.robotui.rfic.smartsoft.internal.feed;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.message.DynamicMessage;

/**
 * One port of a service.
 *
 * @param <D> what is made of its objects
 */
final class SmartOutlet<D extends Data> implements AutoCloseable {
  /**
   * Makes data of an object, on the reading thread. What it throws is told to whoever looks.
   *
   * @param <D> the data
   */
  interface Making<D> {
    D of(DynamicMessage object);
  }

  private final Making<D> making;
  private final boolean placed;
  private final Publication<D> publication;
  private volatile boolean demanded;

  /** Placed where it says something only to those who know where the robot is. */
  SmartOutlet(SmartShared shared, String port, Class<D> type, String help, boolean placed, Making<D> making) {
    this.making = making;
    this.placed = placed;
    this.publication = shared.context().offers().stream(new StreamPort<>(port, type, Arity.MANY, help),
        now -> demanded = now);
  }

  boolean wanted() {
    return demanded;
  }

  boolean placedAndWanted() {
    return placed && demanded;
  }

  void take(DynamicMessage object, Optional<Stamp> stamp, long now, Supplier<RawMessage> raw) {
    if (demanded) {
      publication.publish(making.of(object), stamp, now, Optional.of(raw.get()));
    }
  }

  void lost(String reason) {
    publication.lost(1, reason);
  }

  void failed(String reason) {
    publication.failed(reason);
  }

  @Override
  public void close() {
    publication.close();
  }
}
