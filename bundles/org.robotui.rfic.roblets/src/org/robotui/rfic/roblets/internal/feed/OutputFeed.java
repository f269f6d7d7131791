package org.robotui.rfic.roblets.internal.feed;

import java.util.Optional;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.roblets.ElementRecord;
import org.robotui.message.roblets.RobletFormat;
import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.tree.BodyForm;

/**
 * What a roblet says by one name, as a stream.
 *
 * @param <D> what is made of it
 */
final class OutputFeed<D extends Data> implements AutoCloseable {
  private final Spoken spoken;
  private final String port;
  private final RobletsShared shared;
  private final Making<D> making;
  private final boolean placed;
  private final Publication<D> publication;
  private volatile boolean demanded;

  /**
   * Makes data of a message.
   *
   * @param <D> the data
   */
  interface Making<D> {
    D of(DynamicRecord said, Optional<Stamp> stamp);
  }

  /** What is said, and by whom. */
  record Spoken(String roblet, BodyForm form) {
    String port() {
      return roblet + "/" + form.name();
    }

    RawDefinition definition() {
      return new RawDefinition(RobletFormat.type(roblet, form), RobletFormat.FORM_ENCODING,
          Bytes.of(RobletFormat.definition(form)));
    }
  }

  /** Placed where it says something only to those who know where the robot is. */
  OutputFeed(RobletsShared shared, Spoken spoken, Class<D> type, String help, boolean placed, Making<D> making) {
    this.spoken = spoken;
    this.port = spoken.port();
    this.shared = shared;
    this.making = making;
    this.placed = placed;
    this.publication =
        shared.context().offers().stream(new StreamPort<>(port, type, Arity.MANY, help), now -> demanded = now);
  }

  boolean wanted() {
    return demanded;
  }

  boolean placedAndWanted() {
    return placed && demanded;
  }

  void take(BodyEntry entry, byte[] bytes) {
    Optional<Stamp> stamp = shared.stamp(entry.stampNanos());
    try {
      DynamicRecord said = ElementRecord.of(port, entry.element());
      D value = making.of(said, stamp);
      if (demanded) {
        publication.publish(value, stamp, entry.receivedNanos(), Optional.of(raw(said, bytes)));
      }
    } catch (IllegalArgumentException e) {
      publication.lost(1, port + ": " + e.getMessage());
    }
  }

  private RawMessage raw(DynamicRecord said, byte[] bytes) {
    return new RawMessage(port, RobletFormat.ENCODING, Bytes.wrap(bytes, 0, bytes.length), read -> Optional.of(said),
        new RawOrigin(port, port, false, () -> Optional.of(spoken.definition())));
  }

  void lost(String reason) {
    if (demanded) {
      publication.lost(1, reason);
    }
  }

  /** Says why nothing comes, or by an empty reason that it does. */
  void failed(String reason) {
    publication.failed(reason);
  }

  @Override
  public void close() {
    publication.close();
  }
}
