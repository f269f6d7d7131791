package org.robotui.ros.internal.node;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.robotui.net.process.RunningProcess;

/**
 * Whose a node is.
 *
 * @param host the machine it runs on
 * @param process its process there
 */
record Owner(String host, RunningProcess process) {

  static Owner current() {
    return new Owner(thisHost(), RunningProcess.current());
  }

  /** Asking the name service could take long: the kernel knows it, elsewhere the environment. */
  private static String thisHost() {
    try {
      return Files.readString(Path.of("/proc/sys/kernel/hostname")).strip();
    } catch (IOException e) {
      return Optional.ofNullable(System.getenv("COMPUTERNAME")).or(() -> Optional.ofNullable(System.getenv("HOSTNAME")))
          .orElse("");
    }
  }

  boolean isOnThisHost() {
    return host.equals(thisHost());
  }
}
