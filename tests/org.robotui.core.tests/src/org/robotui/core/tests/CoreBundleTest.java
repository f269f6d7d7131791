package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.Host;

/** The end of core, by an application or with its bundle. */
class CoreBundleTest {
  private static final String YAML = """
      ruics:
        Keira:
          rfics:
            base: fake
          uics:
            words: text
            notes: notes
      """;
  private static final String[] OURS = {"Keira", "ruic-", "arbiter-", "robotui-"};

  private final FakeRobot robot = new FakeRobot("fake");
  private final Notes notes = new Notes();
  private @TempDir Path folder;
  private World world;

  @BeforeEach
  void load() throws Exception {
    world = new World(folder);
    world.bring(robot);
    world.bring(notes);
    world.load(YAML);
    notes.awaitMore();
    assertTrue(World.threads(OURS).toString().contains("Keira.base-"), World.threads(OURS).toString());
  }

  @AfterEach
  void end() throws Exception {
    world.close();
  }

  @Test
  void closingLeavesNoThread() {
    assertEquals(List.of(), world.core().close(Duration.ofSeconds(30)));

    world.awaitNoThread(OURS);
    assertEquals(1, robot.closed().get());
    assertEquals(1, notes.closed().get());
  }

  @Test
  void typesMayComeAndGoAfterClosing() throws Exception {
    world.core().close(Duration.ofSeconds(30));

    Bundles.stop(World.TEXT);
    world.stopBringing(robot);
    Bundles.start(World.TEXT);

    world.awaitNoThread(OURS);
    assertEquals(List.of(), world.core().ruics());
  }

  @Test
  void aStoppedBundleLeavesNoThreadAndNoService() throws Exception {
    Bundles.stop(World.CORE);

    Eventually.await("both are closed", () -> robot.closed().get() == 1 && notes.closed().get() == 1,
        () -> robot.closed() + " " + notes.closed());
    world.awaitNoThread(OURS);
    assertTrue(Bundles.context().getServiceReference(Host.class) == null, "there is no host");
  }
}
