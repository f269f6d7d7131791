package org.robotui.lcm.tests;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;

/** The LCM programs these tests need as peers: the one place that decides whether they can run. */
final class LcmInstallation {

  /** The stock client in Java. */
  static final Path JAR = Path.of("/usr/share/java/lcm.jar");

  private LcmInstallation() {}

  /** Skips the test, with the packages to install, if they are missing. */
  static void assumeThere() {
    boolean there = Files.exists(JAR) && Files.exists(Path.of("/usr/include/lcm/lcm.h")) && succeeds("gcc", "--version")
        && List.of("lcm-gen", "lcm-logger", "lcm-logplayer").stream()
            .allMatch(tool -> succeeds("sh", "-c", "command -v " + tool));
    Assumptions.assumeTrue(there,
        "LCM is not installed: needs gcc and the Debian packages liblcm-bin liblcm-dev liblcm-java");
  }

  private static boolean succeeds(String... command) {
    try {
      Process process = new ProcessBuilder(List.of(command)).redirectErrorStream(true)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
      if (process.waitFor(30, TimeUnit.SECONDS)) {
        return process.exitValue() == 0;
      }
      process.destroyForcibly();
      return false;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
