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
import org.robotui.api.host.FileOutcome;
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

  @Test
  void recordingsAreOpenedInTheirOrder() throws Exception {
    host.opening(List.of(), name -> new FileOutcome.Opened(name, file, List.of("a"), List.of()));

    assertEquals(Exit.FINE.code(), open(folder.resolve("b.bag"), folder.resolve("a.bag")));

    assertEquals(List.of("open TEXT", "open b.bag", "open a.bag", "close"), host.calls());
    assertEquals("", err.toString(StandardCharsets.UTF_8));
  }

  @Test
  void aRecordingThatCannotBeOpenedSaysWhyAndTheOthersGoOn() throws Exception {
    host.opening(List.of(), name -> name.endsWith("b.bag") ? new FileOutcome.NotOpened(name, "b.bag is no bag")
        : new FileOutcome.Opened(name, file, List.of("a"), List.of()));

    assertEquals(Exit.UNREADABLE.code(), open(folder.resolve("b.bag"), folder.resolve("a.bag")));

    assertEquals("b.bag is no bag", err.toString(StandardCharsets.UTF_8).strip());
    assertEquals(List.of("select terminal/a"), ruic.calls());
  }

  private int open(Path... files) throws InterruptedException {
    return run(arguments(List.of(), List.of(files), Optional.of(Duration.ofMillis(20)), Set.of()));
  }

  private int run(Path config, Optional<Duration> limit, String... shown) throws InterruptedException {
    return run(arguments(List.of(config), List.of(), limit, Set.of(shown)));
  }

  private static Arguments arguments(List<Path> configs, List<Path> files, Optional<Duration> limit,
      Set<String> shown) {
    return new Arguments(configs, files, true, limit, Optional.empty(), Optional.empty(), shown, false,
        Optional.empty(), Optional.empty(), false);
  }

  private int run(Arguments arguments) throws InterruptedException {
    return new ShowRun(host, print(out), print(err), stop, Optional.empty()).show(arguments);
  }

  private static PrintStream print(ByteArrayOutputStream bytes) {
    return new PrintStream(bytes, true, StandardCharsets.UTF_8);
  }
}
