package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code releng/ApiVersions.java}, on two small repositories. */
class ApiVersionsTest {

  private static final String BEFORE = """
      public interface Robot {
        void drive(double speed);

        record Pose(double x, double y) {}
      }
      """;

  @TempDir
  Path folder;

  private void checkout(String name, String version, String source) {
    new Fixture(folder.resolve(name))
        .bundle("org.robotui.api", "Export-Package: org.robotui.api;version=\"" + version + "\"")
        .source("org.robotui.api", "org.robotui.api.Robot", source)
        .source("org.robotui.api", "org.robotui.api.Hidden", "class Hidden { public int " + name + "; }");
  }

  private String compared(String version, String now) throws IOException, InterruptedException {
    checkout("before", "1.2.0", BEFORE);
    checkout("now", version, now);
    Path said = folder.resolve("said");
    new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        RepositoryTest.root().resolve("releng/ApiVersions.java").toString(), folder.resolve("before").toString(),
        folder.resolve("now").toString()).redirectErrorStream(true).redirectOutput(said.toFile()).start().waitFor();
    return Files.readString(said);
  }

  @Test
  void what_only_its_own_bundle_sees_has_no_version() throws Exception {
    assertEquals("1 exported packages: each version says what has changed\n", compared("1.2.0", BEFORE));
  }

  @Test
  void what_is_gone_takes_a_major_version() throws Exception {
    String now = BEFORE.replace("drive(double speed)", "drive(float speed)").replace("double y", "double y, double z");

    assertEquals("""
        org.robotui.api was 1.2.0 and is 1.3.0; it must be 2.0.0, as this is gone:
            Robot.Pose(double x, double y)
            Robot.drive(double): void
        1 of 1 exported packages need another version
        """, compared("1.3.0", now));
    assertEquals("1 exported packages: each version says what has changed\n", compared("2.0.0", now));
  }

  @Test
  void what_was_added_takes_a_minor_version() throws Exception {
    String now = BEFORE.replace("void drive", "/** Stops. */\n  default void stop() {}\n\n  void drive");

    assertEquals("""
        org.robotui.api was 1.2.0 and is 1.2.0; it must be 1.3.0, as this was added:
            Robot.stop(): void
        1 of 1 exported packages need another version
        """, compared("1.2.0", now));
    assertEquals("1 exported packages: each version says what has changed\n", compared("1.3.0", now));
  }

  @Test
  void a_record_that_can_be_made_as_before_takes_a_minor_version() throws Exception {
    String now = BEFORE.replace("record Pose(double x, double y) {}",
        "record Pose(double x, double y, double z) {\n    public Pose(double x, double y) {\n      this(x, y, 0);\n    }\n  }");

    assertEquals("1 exported packages: each version says what has changed\n", compared("1.3.0", now));
    assertEquals("""
        org.robotui.api was 1.2.0 and is 1.2.0; it must be 1.3.0, as this was added:
            Robot.Pose(double x, double y, double z)
            Robot.Pose.z(): double
        1 of 1 exported packages need another version
        """, compared("1.2.0", now));
  }
}
