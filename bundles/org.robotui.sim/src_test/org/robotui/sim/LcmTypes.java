package org.robotui.sim;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Where the types of the package {@code robotui} are. */
final class LcmTypes {
  private LcmTypes() {}

  static Path folder() {
    Path folder = Optional.ofNullable(System.getenv("ROBOTUI_ROOT")).map(Path::of).orElse(Path.of("").toAbsolutePath());
    while (folder != null && !Files.isDirectory(folder.resolve("configs/lcm/types"))) {
      folder = folder.getParent();
    }
    return Optional.ofNullable(folder).orElseThrow(() -> new AssertionError("configs/lcm/types is not above here"))
        .resolve("configs/lcm/types");
  }
}
