package org.robotui.ros.internal.node;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;

/**
 * A process, so that it is not mistaken for a later one of the same number.
 *
 * @param host the machine it runs on
 * @param pid its number there
 * @param started when it began; the epoch if the system does not tell
 */
record Owner(String host, long pid, Instant started) {

  /** Systems derive the start from a clock that is corrected meanwhile. */
  private static final Duration TOLERANCE = Duration.ofSeconds(10);

  static Owner current() {
    ProcessHandle self = ProcessHandle.current();
    return new Owner(thisHost(), self.pid(), started(self));
  }

  private static Instant started(ProcessHandle process) {
    return process.info().startInstant().orElse(Instant.EPOCH);
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

  boolean isAlive() {
    return ProcessHandle.of(pid).filter(ProcessHandle::isAlive)
        .map(process -> Duration.between(started(process), started).abs().compareTo(TOLERANCE) < 0).orElse(false);
  }
}
