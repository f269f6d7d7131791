package org.robotui.core.internal.match;

import org.robotui.api.port.Intake;
import org.robotui.api.port.Port;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;

/**
 * A port of a view that wants to be connected.
 *
 * @param id which
 * @param port as its type declares it
 */
public record Want(SourceId id, Port port) {
  /** Whether the view chooses among what fits, as a connection alone brings nothing. */
  boolean chooses() {
    return port instanceof StreamPort<?> stream && stream.intake() == Intake.CHOSEN;
  }
}
