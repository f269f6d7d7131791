package org.robotui.rfic.lcm.internal.session;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmType;

/**
 * What is offered of one channel. Fed by the thread that takes messages; core's threads merely note the demand.
 *
 * @param <D> the data
 */
abstract class Feed<D extends Data> implements AutoCloseable {
  private final Publication<D> publication;
  private volatile boolean wanted;

  Feed(RficContext context, String port, Class<D> data, String help) {
    publication = context.offers().stream(new StreamPort<>(port, data, Arity.MANY, help), w -> wanted = w);
  }

  /** Whether its messages are to be read: somebody looks at them, or the tree of frames needs them. */
  boolean wanted() {
    return wanted;
  }

  final Publication<D> publication() {
    return publication;
  }

  /** The messages are of another type from now on; none where it is not known. */
  abstract void typed(Optional<LcmType> type, String remedy);

  /** What it cannot do, empty where all is well. */
  abstract String problem();

  /** A message of a type that is known. */
  abstract void decoded(LcmRecord record, LcmMessage message, RawMessage raw);

  /** A message of a type that is not known. */
  abstract void unknown(LcmMessage message, RawMessage raw);

  final void publish(D value, Optional<Stamp> stamp, LcmMessage message, RawMessage raw) {
    publication.publish(value, stamp, message.received(), Optional.of(raw));
  }

  /** Says that a message was lost because of what it is. */
  final void lost(LcmMessage message, String reason) {
    publication.lost(1, message.channel() + " from " + message.sender() + ": " + reason);
  }

  @Override
  public void close() {
    publication.close();
  }
}
