package org.robotui.workbench.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.FileOutcome;
import org.robotui.api.host.Problem;
import org.robotui.testkit.host.FakeHost;

class ConfigurationsTest {
  @TempDir
  Path folder;

  private final BlockingQueue<Runnable> display = new LinkedBlockingQueue<>();
  private final List<Path> loaded = new ArrayList<>();
  private final CompletableFuture<Void> components = new CompletableFuture<>();
  private final FakeHost host = new FakeHost();
  private final Configurations configurations =
      new Configurations(host, display::add, (file, problems) -> loaded.add(file), components);

  @AfterEach
  void close() {
    configurations.close();
  }

  @Test
  void areReadWhenTheDisplayKnowsTheOutcomeOfEach() throws Exception {
    components.complete(null);
    assertTrue(configurations.areRead());

    configurations.load(folder.resolve("a.yaml"));
    configurations.load(folder.resolve("b.yaml"));
    assertFalse(configurations.areRead());
    deliver();
    assertFalse(configurations.areRead());
    deliver();
    assertTrue(configurations.areRead());
    assertEquals(2, loaded.size());
  }

  @Test
  void nothingIsReadBeforeTheComponentsAreThere() throws Exception {
    configurations.load(folder.resolve("a.yaml"));
    assertNull(display.poll(50, TimeUnit.MILLISECONDS));

    components.complete(null);
    deliver();
    assertTrue(configurations.areRead());
  }

  @Test
  void aRecordingThatIsOpenedIsKnownByItsRobot() throws Exception {
    Path file = folder.resolve("a.bag");
    List<FileOutcome> told = new ArrayList<>();
    host.opening(List.of(), f -> new FileOutcome.Opened(f, folder.resolve("a.yaml"), List.of("a"), List.of()));
    components.complete(null);
    configurations.open(file, told::add);
    deliver();
    assertEquals(1, told.size());
    assertEquals(Optional.of(file), configurations.openedAs("a"));
    assertEquals(Optional.empty(), configurations.openedAs("b"));
    assertEquals(List.of(), configurations.files());
  }

  @Test
  void aRecordingThatCannotBeOpenedIsAProblemAndIsTriedAgainAsOne() throws Exception {
    Path file = folder.resolve("a.bag");
    components.complete(null);
    configurations.open(file, outcome -> {});
    deliver();
    assertEquals(List.of("no robot interface opens it"),
        configurations.problems().stream().map(Problem::message).toList());
    host.opening(List.of(), f -> new FileOutcome.Opened(f, folder.resolve("a.yaml"), List.of("a"), List.of()));
    configurations.reload();
    deliver();
    assertEquals(List.of(), configurations.problems());
    assertEquals(List.of("open a.bag", "open a.bag"), host.calls());
  }

  private void deliver() throws InterruptedException {
    Runnable task = display.poll(10, TimeUnit.SECONDS);
    assertNotNull(task);
    task.run();
  }
}
