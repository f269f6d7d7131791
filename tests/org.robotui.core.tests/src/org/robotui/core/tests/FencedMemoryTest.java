package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Components that allocate without end, in a process with little memory. */
class FencedMemoryTest {
  /** Of 64 MB the serial collector keeps one room for survivors empty. */
  private static final String GUILTY = "java.lang.OutOfMemoryError: Java heap space, which another may have used up "
      + "(RobotUI may take 62 MB; ROBOTUI_MEMORY=124m gives it more),";
  private static final String BUNDLE = "(bundle org.robotui.tests.bad, class org.robotui.tests.bad.";

  private @TempDir Path folder;

  private ChildProduct product(String rfics, String uics) throws Exception {
    return new ChildProduct(folder, """
        ruics:
          Keira:
            safety:
              Keira: {lease: false}
            rfics:
              base: {type: badrobot, file: %s}
        %s
            uics:
              driver: {type: badview, drives: true}
        %s
        """.formatted(folder.resolve("commands"), rfics, uics), "-Xmx64m", "-XX:+UseSerialGC");
  }

  private String lastCommand() {
    String[] lines = ChildProduct.text(folder.resolve("commands")).split("\n");
    return lines[lines.length - 1].replaceFirst("\\d+ ", "");
  }

  private void awaitCommand(String speed) {
    Eventually.await("the robot does " + speed, () -> lastCommand().equals(speed), this::lastCommand);
  }

  @Test
  void aTickThatTakesAllMemoryIsFencedAndTheProcessGoesOn() throws Exception {
    try (ChildProduct product = product("", "      bad: {type: badview, in: tick, does: hoard, after: 3}")) {
      awaitCommand("1.0");
      product.awaitError("Keira: bad failed: threw " + GUILTY + " in tick " + BUNDLE + "BadView");
      product.awaitMore();
      product.end();
      awaitCommand("0.0");
    }
  }

  @Test
  void aThreadThatTakesAllMemoryEndsItsRobotInterfaceAndTheProcessGoesOn() throws Exception {
    try (ChildProduct product =
        product("      bad: {type: badrobot, robot: Other, in: thread, does: hoard, after: 3}", "")) {
      awaitCommand("1.0");
      product.awaitError(" ended with " + GUILTY + " " + BUNDLE + "BadRobot");
      product.awaitMore();
      product.end();
      awaitCommand("0.0");
    }
  }

  @Test
  void memoryThatIsNearlyUsedUpIsToldWithTheBoundAndHowToRaiseItAndStopsNobody() throws Exception {
    try (ChildProduct product = product("", "      bad: {type: badview, in: task, does: hoard_most, after: 3}")) {
      awaitCommand("1.0");
      product.awaitError(
          "MB of memory, and stops all robots when they are used up: close views or robots, or start it with more, as by "
              + "ROBOTUI_MEMORY=124m");
      product.awaitMore();
      awaitCommand("1.0");
    }
  }

  @Test
  void memoryThatNeverComesBackStopsAllRobots() throws Exception {
    try (ChildProduct product = product("", "      bad: {type: badview, in: task, does: hoard_for_ever, after: 3}")) {
      awaitCommand("1.0");
      awaitCommand("0.0");
      // Which of the two comes first depends on who needs memory first: the watch to say so, or somebody else.
      product.awaitError("the memory is used up (", "OutOfMemoryError");
      assertTrue(product.isAlive());
    }
  }
}
