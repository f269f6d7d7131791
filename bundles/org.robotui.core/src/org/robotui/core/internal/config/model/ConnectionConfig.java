package org.robotui.core.internal.config.model;

import java.util.List;
import org.robotui.api.port.SourceId;

/**
 * A connection that the file names.
 *
 * @param port the port of a view
 * @param peers ports of robot interfaces; empty where the port shall stay unconnected
 * @param line from 1
 * @param column from 1
 */
public record ConnectionConfig(SourceId port, List<SourceId> peers, int line, int column) {
  /**
   * Copies the list.
   *
   * @param port the port of a view
   * @param peers ports of robot interfaces
   * @param line from 1
   * @param column from 1
   */
  public ConnectionConfig {
    peers = List.copyOf(peers);
  }
}
