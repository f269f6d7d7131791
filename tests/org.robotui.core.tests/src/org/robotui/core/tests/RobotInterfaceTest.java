package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.RuicState;

/** Types of robot interfaces come and go as services, under a RUIC that was loaded before. */
class RobotInterfaceTest {
  private static final String YAML = """
      ruics:
        Keira:
          rfics:
            base: {type: fake, peer: here}
            arm: {type: later, peer: there}
          uics:
            words: text
            notes: notes
          connect:
            notes.battery: base.battery
      """;

  private final FakeRobot robot = new FakeRobot("fake");
  private final FakeRobot later = new FakeRobot("later");
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
  }

  @AfterEach
  void end() throws Exception {
    world.close();
  }

  @Test
  void withATypeItsPortsAndThreadsGoAndReturn() {
    assertEquals(List.of("base.battery"), world.ports());

    world.stopBringing(robot);

    assertEquals(1, robot.closed().get(), "nothing of it runs when its service is gone, so that its bundle may go");
    world.awaitNoThread("Keira.base");
    world.await("base", RuicState.FAILED);
    Match match = world.awaitMatch("notes.battery", m -> m.state() == MatchState.PENDING);
    assertEquals(List.of(), match.peers());
    assertEquals("notes needs Battery on 'battery'; base.battery, named by " + folder.resolve("robot.yaml")
        + ":10, is not there; base has failed: type 'fake' is not there; install or start bundle org.robotui.core.tests",
        match.reason());
    assertEquals(List.of(), world.ports());
    world.await("notes", RuicState.SELECTED);

    world.bring(robot);

    notes.awaitMore();
    world.awaitMatch("words.all", m -> m.state() == MatchState.CONNECTED);
    assertEquals(List.of("here", "here"), robot.peers(), "it has its settings again");
    assertEquals(1, notes.contexts().size(), "the view is the same");
  }

  @Test
  void aTypeThatNobodyKnewCompletesTheRuicWhenItAppears() {
    world.await("arm", RuicState.FAILED);
    assertTrue(world.reason("arm").matches("type 'later' is not installed; "
        + "installed are carmen, fake, lcm, player, roblets, ros, ros2, smartsoft, yarp"),
        world.reason("arm"));

    world.bring(later);

    world.await("arm", RuicState.INITIALIZED);
    assertEquals(List.of("there"), later.peers());
    Match match = world.awaitMatch("words.all", m -> m.peers().size() == 2);
    assertTrue(match.peers().toString().contains("arm.battery"), match.toString());
    assertEquals(List.of("here"), robot.peers(), "the other one was not started again");
  }

  @Test
  void theSecondOfTwoBundlesWithOneTypeStepsInForTheFirst() {
    FakeRobot other = new FakeRobot("fake");
    world.bring(other);

    world.stopBringing(robot);

    world.await("base", RuicState.INITIALIZED);
    notes.awaitMore();
    assertEquals(List.of("here"), other.peers());
    assertEquals(1, robot.closed().get());
  }

  @Test
  void aTypeMayComeAndGoManyTimes() {
    for (int i = 0; i < 20; i++) {
      world.stopBringing(robot);
      assertEquals(robot.peers().size(), robot.closed().get(), "all that were made have ended");
      world.bring(robot);
    }

    notes.awaitMore();
    assertEquals(robot.peers().size() - 1, robot.closed().get(), "one runs");
    assertEquals(List.of("base.battery"), world.ports());
  }
}
