package org.robotui.roblets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyPath;
import org.robotui.roblets.wire.RobletStatus;

/** A roblet in Python, a process of its own: it is killed, comes back, and nobody else loses anything. */
@Timeout(120)
class PythonRobletTest {
  private static final String SCRIPT = """
      import roblet
      class Depth(roblet.Roblet):
          name, frequency = "depth", 20
          outputs = {"depth": {"fields": {"metres": "number", "gain": "number"}}}
          inputs = {"gain": {"fields": {"value": "number"}}}
          gain = 1.0
          def run(self):
              self.say("depth", metres=12.5, gain=self.gain)
          def receive(self, sender, message):
              self.gain = float(message.get("value"))
      Depth().live()
      """;
  private static final Path MODULE = Path.of("..", "..", "tools", "python", "roblet.py");
  private static final BodyPath GAIN = BodyPath.parse("depth/depth/@gain");

  private final TestBody body = new TestBody();
  private Optional<Process> depth = Optional.empty();

  PythonRobletTest() throws IOException {
    // the body begins in its field
  }

  @BeforeEach
  void begin() throws IOException {
    boolean there = Files.exists(MODULE) && ProcessHandle.current().info().command().isPresent();
    assumeTrue(there && hasPython(), "python3 is needed");
  }

  private static boolean hasPython() {
    try {
      return new ProcessBuilder("python3", "--version").redirectErrorStream(true).start().waitFor() == 0;
    } catch (IOException | InterruptedException e) {
      return false;
    }
  }

  private Process start() throws IOException {
    ProcessBuilder builder = new ProcessBuilder("python3", "-c", SCRIPT).inheritIO();
    builder.environment().put("PYTHONPATH", MODULE.getParent().toAbsolutePath().toString());
    builder.environment().put("ROBLETS_BRAIN", "127.0.0.1:" + body.brain().port());
    Process process = builder.start();
    depth = Optional.of(process);
    return process;
  }

  @AfterEach
  void end() {
    depth.ifPresent(Process::destroyForcibly);
    body.close();
  }

  private RobletStatus status(String roblet) {
    return body.brain().roblets().stream().filter(s -> s.form().name().equals(roblet)).findFirst().orElseThrow();
  }

  private double gain() {
    return body.brain().bodymap().snapshot().number(GAIN).orElse(0);
  }

  @Test
  void it_is_killed_and_comes_back_and_nobody_else_loses_anything() throws IOException {
    body.run(() -> new RobletLifeTest.Heart(new AtomicLong(), new AtomicBoolean()));
    Process first = start();
    body.await("it is heard", () -> gain() == 1);
    body.await("it takes messages", () -> {
      body.brain().say("depth", BodyElement.of("gain").with("value", 3));
      return gain() == 3;
    });
    first.destroyForcibly();
    body.await("that is told", () -> status("depth").state().equals(RobletStatus.SILENT));
    Process second = start();
    body.await("it is another one", () -> gain() == 1 && status("depth").state().equals(RobletStatus.RUNNING));
    assertEquals(2, status("depth").tally().runs());
    RobletStatus heart = status("heart");
    assertTrue(heart.tally().lost() + heart.tally().late() + heart.tally().doubled() == 0
        && heart.tally().runs() == 1, heart::toString);
    second.destroy();
    body.await("it goes with a word", () -> status("depth").state().equals(RobletStatus.STOPPED));
  }
}
