package org.robotui.core.internal.command;

import org.robotui.api.port.CommandSink.Sent;

/** How a port answered to a latched stop. */
enum StopAnswer {
  /** It went out, or is on its way. */
  TAKEN,
  /** Sending it failed before it was answered, as there was no memory: it has to be said again. */
  LOST,
  /** It did not. */
  REFUSED,
  /** It does not concern the port. */
  UNNEEDED;

  static StopAnswer of(Sent sent) {
    return switch (sent) {
      case Sent.Out out -> TAKEN;
      case Sent.Refused refused -> REFUSED;
      case Sent.Unneeded unneeded -> UNNEEDED;
    };
  }
}
