package org.robotui.api.bridge;

import org.robotui.api.port.SourceId;

/**
 * One end of a bridge.
 *
 * @param ruic the name of the RUIC whose robot interface it is
 * @param port the port, which need not be there yet; for a topic or channel that is to be offered its name
 */
public record BridgeEnd(String ruic, SourceId port) {
  @Override
  public String toString() {
    return ruic + "." + port;
  }
}
