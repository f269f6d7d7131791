package org.robotui.ros.internal.node;

import org.robotui.net.process.RunningProcess;
import org.robotui.net.process.ThisMachine;

/**
 * Whose a node is.
 *
 * @param host the machine it runs on
 * @param process its process there
 */
record Owner(String host, RunningProcess process) {

  static Owner current() {
    return new Owner(ThisMachine.name(), RunningProcess.current());
  }

  boolean isOnThisHost() {
    return host.equals(ThisMachine.name());
  }
}
