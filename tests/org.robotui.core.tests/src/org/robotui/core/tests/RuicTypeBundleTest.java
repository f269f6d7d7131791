package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;
import org.robotui.api.layout.Layout;

/** The bundle that says which views a RUIC has comes and goes. */
class RuicTypeBundleTest {
  private static final String YAML = """
      ruics:
        Keira:
          type: single
          view: text
          rfics:
            base: {type: fake, peer: here}
          connect:
            text.all: base.battery
      """;

  private final FakeRobot robot = new FakeRobot("fake");
  private @TempDir Path folder;
  private World world;

  @BeforeEach
  void start() throws Exception {
    world = new World(folder);
    world.bring(robot);
  }

  @AfterEach
  void end() throws Exception {
    world.close();
  }

  private void awaitRunning(Ruic ruic) {
    world.awaitRuic(RuicState.SELECTED);
    world.await("text", RuicState.SELECTED);
    world.awaitText("text", "base.battery");
    world.awaitMatch("text.all", m -> m.state() == MatchState.CONNECTED);
    assertEquals(new Layout.View("text"), ruic.layout());
  }

  @Test
  void aRuicIsLoadedAlsoWithoutItsTypeAndRunsWhenThatAppears() throws Exception {
    world.uninstall(World.SINGLE);
    Ruic ruic = world.load(YAML);
    world.awaitRuic(RuicState.FAILED);
    String reason = ruic.snapshot().reason();
    assertTrue(reason.startsWith("type 'single' is not"), reason);
    assertEquals(List.of(), robot.peers(), "nothing was started");

    world.install(World.SINGLE);

    awaitRunning(ruic);
    assertEquals(List.of("here"), robot.peers());
  }

  @Test
  void aRunningRuicThatLosesItsTypeEndsAndReturns() throws Exception {
    Ruic ruic = world.load(YAML);
    awaitRunning(ruic);

    Bundles.stop(World.SINGLE);

    world.awaitRuic(RuicState.FAILED);
    assertEquals("type 'single' is not there; install or start bundle org.robotui.ruic.single",
        ruic.snapshot().reason());
    Eventually.await("its robot interface is closed", () -> robot.closed().get() == 1, robot.closed()::get);
    world.awaitNoThread("Keira.");

    Bundles.start(World.SINGLE);

    awaitRunning(ruic);
  }

  @Test
  void allBundlesMayBeRefreshedAtOnce() throws Exception {
    Ruic ruic = world.load(YAML);
    awaitRunning(ruic);

    Bundles.refresh(World.SINGLE, World.TEXT);

    awaitRunning(ruic);
  }
}
