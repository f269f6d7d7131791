package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.TextUic;
import org.robotui.core.tests.Wheels.Command;
import org.robotui.testkit.MachineLoad;

/** A view that misbehaves on the display thread, which core can watch but not fence. */
class FencedDisplayTest {
  private static final long SILENCE_NANOS = 200_000_000L;
  private static final long SLACK_NANOS = 400_000_000L;

  private @TempDir Path folder;
  private Fence fence;
  private DisplayThread display;

  @BeforeEach
  void start() throws Exception {
    fence = new Fence(folder);
    fence.world.bring(new Pulse("driver", true));
    display = new DisplayThread(fence.world.core());
  }

  @AfterEach
  void end() throws Exception {
    display.close();
    fence.close();
  }

  private void show(String settings) throws Exception {
    fence.load("", "      driver: driver\n      bad: {type: badview, " + settings + "}");
    fence.wheels.awaitMoving();
    Eventually.await("the view is there", () -> fence.keira().uic("bad").isPresent(), fence.keira()::snapshot);
    TextUic bad = (TextUic) fence.keira().uic("bad").orElseThrow();
    display.execute(() -> bad.lines(80, 24));
  }

  @Test
  void whileItBlocksTheRobotStandsStillAndTheUserReadsWhoItIs() throws Exception {
    show("in: lines, does: wait");
    fence.world.awaitAlert("holds it up");
    long silentSince = display.lastBeat();
    long stopped = fence.wheels.awaitStopped() - silentSince;
    long limit = SILENCE_NANOS + Math.round(SLACK_NANOS * MachineLoad.factor());
    assertTrue(stopped > SILENCE_NANOS && stopped < limit,
        "it is stopped in time, not after " + stopped);

    assertTrue(
        fence.world.alerts().stream().anyMatch(
            a -> a.matches(": the display has not answered for \\d+\\.\\d s; bundle org.robotui.tests.bad holds it up "
                + "at org.robotui.tests.bad.Misdeed.*; what its windows moved is stopped")),
        fence.world.alerts().toString());
    fence.assertTheOthersGoOn();
    assertTrue(since(silentSince + limit).stream().allMatch(Command::isZero),
        "it stands still meanwhile");

    display.interrupt();
    fence.world.awaitAlert(" s; bundle org.robotui.tests.bad held it up");
    fence.wheels.awaitMoving();
  }

  private List<Command> since(long nanos) {
    return fence.wheels.commands().stream().filter(c -> c.nanos() > nanos).toList();
  }

  @Test
  void aThreadThatWasStartedThereIsNamedAtTheEnd() throws Exception {
    show("in: lines, does: leak");
    Eventually.await("it is started", () -> !World.threads("leaked-").isEmpty(), () -> World.threads("leaked-"));
    String left = fence.close(Duration.ofSeconds(5)).toString();
    assertTrue(left.matches(".*bad left threads that no factory made: leaked-\\d+ "
        + "\\(bundle org.robotui.tests.bad, class .*"), left);
  }
}
