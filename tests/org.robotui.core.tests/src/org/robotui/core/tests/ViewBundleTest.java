package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.Uic;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;

/** The bundle of a view comes and goes under a RUIC that has it twice, beside another view. */
class ViewBundleTest {
  private static final String YAML = """
      ruics:
        Keira:
          rfics:
            base: {type: fake, peer: here}
          uics:
            plain: {type: text, types: false}
            typed: text
            notes: {type: notes, zoom: 4}
      """;

  private final FakeRobot robot = new FakeRobot("fake");
  private final Notes notes = new Notes();
  private @TempDir Path folder;
  private World world;
  private Ruic ruic;

  @BeforeEach
  void load() throws Exception {
    world = new World(folder);
    world.bring(robot);
    world.bring(notes);
    ruic = world.load(YAML);
    awaitText();
  }

  @AfterEach
  void end() throws Exception {
    world.close();
  }

  /** Both views of the bundle run, with the settings that are written. */
  private void awaitText() {
    world.await("plain", RuicState.SELECTED);
    world.await("typed", RuicState.SELECTED);
    world.awaitMatch("plain.all", m -> m.peers().toString().equals("[base.battery]"));
    world.awaitText("plain", "base.battery", text -> !text.contains("Battery"));
    world.awaitText("typed", "base.battery", text -> text.contains("Battery"));
  }

  private void awaitLoss() {
    world.await("plain", RuicState.FAILED);
    world.await("typed", RuicState.FAILED);
    Eventually.await("it is gone", () -> ruic.uic("plain").isEmpty(), ruic::snapshot);
    world.awaitNoThread("Keira.plain", "Keira.typed");
  }

  private void assertTheOthersWentOn() {
    world.await("notes", RuicState.SELECTED);
    world.awaitRuic(RuicState.SELECTED);
    notes.awaitMore();
    assertEquals(1, notes.contexts().size(), "it is the same view");
    assertEquals(List.of("here"), robot.peers(), "it is the same robot interface");
  }

  @Test
  void aStoppedBundleIsNamedAndWhenItStartsItsViewsRunAgainAsTheyWere() throws Exception {
    Bundles.stop(World.TEXT);

    awaitLoss();
    assertEquals("type 'text' is not there; install or start bundle org.robotui.uic.text", world.reason("plain"));
    world.awaitAlert("Keira: typed failed: type 'text' is not there");
    assertTheOthersWentOn();

    Bundles.start(World.TEXT);

    awaitText();
    assertEquals("", world.reason("plain"));
    assertTheOthersWentOn();
  }

  @Test
  void anUninstalledBundleReturnsWhenItIsInstalledAnew() throws Exception {
    Uic before = ruic.uic("plain").orElseThrow();
    world.uninstall(World.TEXT);

    awaitLoss();
    assertTrue(world.reason("plain").contains("install or start bundle org.robotui.uic.text"), world.reason("plain"));
    assertTheOthersWentOn();

    world.install(World.TEXT);

    awaitText();
    assertNotSame(before.getClass(), ruic.uic("plain").orElseThrow().getClass(),
        "the classes are those of the new bundle");
    assertTheOthersWentOn();
  }

  @Test
  void packagesMayBeRefreshedWhileTheBundleIsAway() throws Exception {
    world.uninstall(World.TEXT);
    Bundles.refresh();

    awaitLoss();
    assertTheOthersWentOn();

    world.install(World.TEXT);
    Bundles.refresh(World.TEXT);
    awaitText();
    assertTheOthersWentOn();
  }

  @Test
  void aRefreshedBundleIsTakenAnewWhileItRuns() throws Exception {
    Uic before = ruic.uic("plain").orElseThrow();

    Bundles.refresh(World.TEXT);

    awaitText();
    assertNotSame(before.getClass(), ruic.uic("plain").orElseThrow().getClass(),
        "the classes are those of the new wiring");
    assertTheOthersWentOn();
  }

  @Test
  void whatTheUserSetIsInForceAgainWhenAViewReturns() throws Exception {
    assertEquals(4, notes.zoom());
    notes.contexts().getLast().settings().set(Notes.ZOOM, 7.5);
    Notes newer = new Notes();
    world.bring(newer);
    assertEquals(0, newer.contexts().size(), "the first of two is used");

    world.stopBringing(notes);

    newer.awaitMore();
    assertEquals(7.5, newer.zoom());
    assertEquals(1, notes.closed().get());
    awaitText();
  }
}
