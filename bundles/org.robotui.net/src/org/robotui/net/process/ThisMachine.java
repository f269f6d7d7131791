package org.robotui.net.process;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The machine that this runs on. Safe for all threads. */
public final class ThisMachine {
  private ThisMachine() {}

  /**
   * Its name. Asking the name service could take long: the kernel knows it, elsewhere the environment.
   *
   * @return the name; empty where nobody knows it
   */
  public static String name() {
    try {
      return Files.readString(Path.of("/proc/sys/kernel/hostname")).strip();
    } catch (IOException e) {
      return Optional.ofNullable(System.getenv("COMPUTERNAME")).or(() -> Optional.ofNullable(System.getenv("HOSTNAME")))
          .orElse("");
    }
  }
}
