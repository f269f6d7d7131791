package org.robotui.api.bridge;

import java.util.List;

/**
 * Runs the bridges of the configurations that are loaded: an OSGi service. Nothing is carried before an application
 * says so. Safe for all threads; never blocks, but for {@link #stop}.
 */
public interface Bridges {
  /** Carries from now on, also what is configured later. Does nothing where it does so already. */
  void start();

  /** Ends: what bridges move is stopped, and leases are given back. */
  void stop();

  /**
   * How they are doing.
   *
   * @return an entry for each way of each bridge, in the order of the files; empty before the start
   */
  List<BridgeStatus> statuses();
}
