package org.robotui.core.tests;

import java.io.IOException;
import java.nio.file.Files;
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
        """.formatted(folder.resolve("commands"), rfics, uics).replace("SIGN", sign().toString()), "-Xmx64m",
        "-XX:+UseSerialGC");
  }

  private Path sign() {
    return folder.resolve("sign");
  }

  /** Once the robot drives, what misbehaves begins to. */
  private void begin() throws IOException {
    awaitCommand("1.0");
    Files.createFile(sign());
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
    try (ChildProduct product = product("", "      bad: {type: badview, in: tick, does: hoard, sign: SIGN}")) {
      begin();
      product.awaitError("Keira: bad failed: threw " + GUILTY + " in tick " + BUNDLE + "BadView");
      product.awaitMore();
      product.end();
      awaitCommand("0.0");
    }
  }

  @Test
  void aThreadThatTakesAllMemoryEndsItsRobotInterfaceAndTheProcessGoesOn() throws Exception {
    try (ChildProduct product =
        product("      bad: {type: badrobot, robot: Other, in: thread, does: hoard, sign: SIGN}", "")) {
      begin();
      product.awaitError(" ended with " + GUILTY + " " + BUNDLE + "BadRobot");
      product.awaitMore();
      product.end();
      awaitCommand("0.0");
    }
  }

  @Test
  void memoryThatIsNearlyUsedUpIsToldWithTheBoundAndHowToRaiseItAndStopsNobody() throws Exception {
    try (ChildProduct product = product("", "      bad: {type: badview, in: task, does: hoard_most, sign: SIGN}")) {
      begin();
      product.awaitError(
          "MB of memory, and stops all robots when they are used up: close views or robots, or start it with more, as by "
              + "ROBOTUI_MEMORY=124m");
      product.awaitMore();
      awaitCommand("1.0");
    }
  }

  @Test
  void memoryThatNeverComesBackStopsAllRobots() throws Exception {
    try (ChildProduct product = product("", "      bad: {type: badview, in: task, does: hoard_for_ever, sign: SIGN}")) {
      begin();
      awaitCommand("0.0");
      product.awaitError("the memory is used up (");
      product.awaitMore();
    }
  }
}
