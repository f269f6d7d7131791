package org.robotui.rfic.player.internal.device;

import java.util.Optional;
import org.robotui.api.port.RawMessage;
import org.robotui.data.Stamp;

/**
 * How a message came.
 *
 * @param stamp when it was measured
 * @param nanos when it was received, {@link System#nanoTime()}
 * @param raw the message itself
 */
record Reception(Optional<Stamp> stamp, long nanos, Optional<RawMessage> raw) {
  static Reception now() {
    return new Reception(Optional.empty(), System.nanoTime(), Optional.empty());
  }
}
