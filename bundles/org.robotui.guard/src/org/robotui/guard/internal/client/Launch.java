package org.robotui.guard.internal.client;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.guard.internal.process.GuardMain;

/** How the process of a guard is started. */
@FunctionalInterface
public interface Launch {
  /**
   * Starts it.
   *
   * @return what runs
   * @throws IOException says why it cannot
   */
  Process start() throws IOException;

  /**
   * With the Java that runs here, from where this class comes. In a session of its own where that is possible, so that
   * what stops or ends all programs of a terminal leaves it alone.
   *
   * @return the usual way
   */
  static Launch ofThisMachine() {
    return () -> {
      List<String> command = new ArrayList<>();
      session().ifPresent(command::add);
      command.addAll(List.of(java().toString(), "-Xms4m", "-Xmx32m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1",
          "-XX:-UsePerfData",
          "-cp", classes().toString(), GuardMain.class.getName(), Long.toString(ProcessHandle.current().pid())));
      ProcessBuilder builder =
          new ProcessBuilder(command).redirectErrorStream(true).directory(new File(System.getProperty("java.home")));
      List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "_JAVA_OPTIONS").forEach(builder.environment()::remove);
      return builder.start();
    };
  }

  private static Optional<String> session() {
    return Stream.of("/usr/bin/setsid", "/bin/setsid").filter(program -> Files.isExecutable(Path.of(program)))
        .findFirst();
  }

  private static Path java() throws IOException {
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    if (!Files.isExecutable(java)) {
      throw new IOException("there is no " + java + "; run this with a Java that has its bin folder");
    }
    return java;
  }

  /** A jar, or a folder of classes; in the IDE and in tests that may lie below the bundle's folder. */
  private static Path classes() throws IOException {
    try {
      CodeSource source = GuardMain.class.getProtectionDomain().getCodeSource();
      Path place = Path.of(source.getLocation().toURI());
      String name = GuardMain.class.getName().replace('.', '/') + ".class";
      return Stream.of(place, place.resolve("target/classes"), place.resolve("bin"))
          .filter(path -> Files.isRegularFile(path) || Files.exists(path.resolve(name))).findFirst()
          .orElseThrow(() -> new IOException("its classes are not in " + place));
    } catch (URISyntaxException | IllegalArgumentException | NullPointerException e) {
      throw new IOException("where its classes are is not known: " + e, e);
    }
  }
}
