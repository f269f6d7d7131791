package org.robotui.message.recorded;

import java.nio.file.Files;
import java.nio.file.Path;

import org.junit.jupiter.api.Assumptions;

/** Finds the recordings that are shared beside the repository; tests that need one are skipped without it. */
final class SharedData {

  private SharedData() {}

  static Path bag(String name) {
    Assumptions.assumeTrue(org.robotui.testkit.recorded.SharedData.available(),
        org.robotui.testkit.recorded.SharedData.REASON);
    Path bag = org.robotui.testkit.recorded.SharedData.file("bags/" + name);
    Assumptions.assumeTrue(Files.isReadable(bag), "no shared recording " + name);
    return bag;
  }
}
