package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.Problem;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;

class ShowRunTest {
  private final FakeHost host = new FakeHost();
  private final FakeRuic ruic = new FakeRuic("a");
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final CountDownLatch stop = new CountDownLatch(1);
  private @TempDir Path folder;
  private Path file;

  @BeforeEach
  void write() throws Exception {
    file = Files.createFile(folder.resolve("a.yaml"));
    host.add(ruic);
  }

  @Test
  void endsByItselfAndClosesTheCore() throws Exception {
    assertEquals(Exit.FINE.code(), run(file, Optional.of(Duration.ofMillis(50))));

    assertEquals(List.of("open TEXT", "load a.yaml", "close"), host.calls());
    assertEquals(List.of("select terminal/a"), ruic.calls());
    assertEquals(0, host.listeners());
  }

  @Test
  void whatStartsWhenItIsShownIsLeftAloneUnlessItIsAskedFor() throws Exception {
    FakeRuic waiting = new FakeRuic("waiting").waiting();
    FakeRuic shown = new FakeRuic("shown").waiting();
    host.add(waiting).add(shown);

    run(file, Optional.of(Duration.ofMillis(20)), "shown");

    assertEquals(List.of(), waiting.calls());
    assertEquals(List.of("select terminal/shown"), shown.calls());
    assertEquals("waiting is not started, as it starts when it is shown; show it with  --show \"waiting\"",
        err.toString(StandardCharsets.UTF_8).strip());
  }

  @Test
  void endsWhenItIsStopped() throws Exception {
    stop.countDown();

    assertEquals(Exit.FINE.code(), run(file, Optional.empty()));

    assertEquals("close", host.calls().getLast());
  }

  @Test
  void aFileThatIsNotThereHasItsOwnExitCode() throws Exception {
    assertEquals(Exit.UNREADABLE.code(), run(folder.resolve("none.yaml"), Optional.of(Duration.ZERO)));

    assertTrue(err.toString(StandardCharsets.UTF_8).startsWith("there is no file "));
  }

  @Test
  void errorsArePrintedAndTheOthersGoOn() throws Exception {
    host.finding(new Problem("a.yaml", 1, 2, Problem.Severity.ERROR, "wrong"));

    assertEquals(Exit.ERRORS.code(), run(file, Optional.of(Duration.ofMillis(20))));

    assertEquals("a.yaml:1:2: error: wrong", err.toString(StandardCharsets.UTF_8).strip());
  }

  private int run(Path config, Optional<Duration> limit, String... shown) throws InterruptedException {
    Set<String> names = Set.of(shown);
    Arguments arguments =
        new Arguments(List.of(config), true, limit, Optional.empty(), Optional.empty(), names, false, Optional.empty(),
            Optional.empty(), false);
    return new ShowRun(host, print(out), print(err), stop, Optional.empty()).show(arguments);
  }

  private static PrintStream print(ByteArrayOutputStream bytes) {
    return new PrintStream(bytes, true, StandardCharsets.UTF_8);
  }
}
