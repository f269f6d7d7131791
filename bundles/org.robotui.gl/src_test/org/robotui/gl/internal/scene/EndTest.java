package org.robotui.gl.internal.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.common.os.Platform;
import com.jogamp.opengl.GL;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.geometry.Vector3;
import org.robotui.gl.internal.context.GlThread;
import org.slf4j.Logger;

/** A signal ends a program that draws, and nothing is printed. */
@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+", disabledReason = "no display: DISPLAY is not set")
class EndTest {
  private static final String DRAWN = "drawn";
  private static final int SIGTERM = 143;

  /** Draws one picture, says so, and waits for its end. */
  static final class Program {
    private Program() {}

    public static void main(String[] arguments) throws Exception {
      try (Stage stage = new Stage()) {
        stage.picture(Stage.request());
        System.out.println(DRAWN);
        Thread.currentThread().join();
      }
    }
  }

  @Test
  void aSignalEndsOpenGlInOrderAndNothingIsPrinted() throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
    ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
        .filter(a -> a.startsWith("-Dj") || a.startsWith("--enable")).forEach(command::add);
    command.addAll(List.of("-Djava.awt.headless=true", "-cp", classPath(), Program.class.getName()));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    try (BufferedReader words = process.inputReader(StandardCharsets.UTF_8)) {
      while (!DRAWN.equals(words.readLine())) {
        assertTrue(process.isAlive(), "it ended before it was told to");
      }
      process.toHandle().destroy(); // which leaves its words to be read
      assertEquals(List.of(), words.lines().toList());
      assertTrue(process.waitFor(60, TimeUnit.SECONDS));
      assertEquals(SIGTERM, process.exitValue());
    } finally {
      process.destroyForcibly();
    }
  }

  /** The places of the classes it needs; the class path of a test runner is its own affair. */
  private static String classPath() {
    return Stream.of(EndTest.class, GlThread.class, GL.class, Platform.class, Vector3.class, Logger.class)
        .map(
            type -> Path.of(URI.create(type.getProtectionDomain().getCodeSource().getLocation().toString())).toString())
        .distinct().collect(Collectors.joining(File.pathSeparator));
  }
}
