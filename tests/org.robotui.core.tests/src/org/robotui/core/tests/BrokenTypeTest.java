package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.RuicState;

/** A type that cannot make an instance, beside others. */
class BrokenTypeTest {
  private static final String YAML = """
      ruics:
        Keira:
          rfics:
            base: fake
            broken: broken
          uics:
            notes: notes
      """;

  private final Notes notes = new Notes();
  private @TempDir Path folder;
  private World world;

  @BeforeEach
  void start() throws Exception {
    world = new World(folder);
    world.bring(new FakeRobot("fake"));
    world.bring(notes);
  }

  @AfterEach
  void end() throws Exception {
    world.close();
  }

  @Test
  void itFailsNamingBundleAndClassAndTheOthersRun() throws Exception {
    world.bring(new BrokenRobot());
    world.load(YAML);

    awaitBroken();
    notes.awaitMore();
  }

  @Test
  void itFailsSoAlsoWhenItAppearsLaterAndWhenItReturns() throws Exception {
    BrokenRobot type = new BrokenRobot();
    world.load(YAML);
    world.await("broken", RuicState.FAILED);
    world.bring(type);
    world.awaitAlert("no such device");
    awaitBroken();

    world.stopBringing(type);
    assertEquals("type 'broken' is not there; install or start bundle org.robotui.core.tests", world.reason("broken"));
    world.bring(type);

    Eventually.await("it failed again", () -> world.reason("broken").contains("no such device"),
        () -> world.reason("broken"));
    awaitBroken();
    notes.awaitMore();
  }

  private void awaitBroken() {
    world.await("broken", RuicState.FAILED);
    String reason = world.reason("broken");
    assertTrue(reason.startsWith("threw java.lang.UnsupportedOperationException: no such device in create"), reason);
    assertTrue(reason.endsWith("(bundle org.robotui.core.tests, class " + BrokenRobot.class.getName() + ")"), reason);
    world.awaitNoThread("Keira.broken");
    world.awaitRuic(RuicState.SELECTED);
  }
}
