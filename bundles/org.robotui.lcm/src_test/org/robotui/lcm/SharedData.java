package org.robotui.lcm;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Assumptions;

/** The recordings that are shared between repositories. */
public final class SharedData {

  private SharedData() {}

  /** A file or folder of the recordings of LCM; skips the test if it is not there. */
  public static Path lcm(String name) {
    Path root = Path.of(Optional.ofNullable(System.getenv("ROBOTUI_SHARED")).orElse("../../../shared"));
    Path file = root.resolve("data/lcm").resolve(name);
    Assumptions.assumeTrue(Files.exists(file), file + " is not there: set ROBOTUI_SHARED to the folder of recordings");
    return file;
  }
}
