package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.RuicState;

/** The bundle that speaks ROS comes and goes while the simulated robot goes on. */
class RosBundleTest {
  private static final String SCAN = "base.scan";

  private static Simulator simulator;

  private @TempDir Path folder;
  private World world;

  @BeforeAll
  static void startRobot() throws Exception {
    simulator = new Simulator();
  }

  @AfterAll
  static void endRobot() throws Exception {
    simulator.close();
  }

  @BeforeEach
  void load() throws Exception {
    world = new World(folder);
    world.load("""
        ruics:
          Natalie:
            type: single
            view: text
            rfics:
              base: {type: ros, master: '%s', host: 127.0.0.1}
            uics:
              text: {unused: false}
            connect:
              text.all: base.scan
        """.formatted(simulator.master()));
    awaitScans();
  }

  @AfterEach
  void end() throws Exception {
    world.close();
  }

  private void awaitScans() {
    world.awaitMatch("text.all", m -> m.state() == MatchState.CONNECTED);
    Eventually.await("scans come", () -> world.port(SCAN).filter(p -> p.rateHz() > 1 && !p.stale()).isPresent(),
        () -> world.port(SCAN));
    world.awaitText("text", "LaserScan");
    world.awaitText("text", "base (ros)  connected: ");
  }

  private void awaitLoss() {
    world.await("base", RuicState.FAILED);
    assertEquals("type 'ros' is not there; install or start bundle org.robotui.rfic.ros", world.reason("base"));
    String reason = world.awaitMatch("text.all", m -> m.state() == MatchState.PENDING).reason();
    assertTrue(reason.endsWith("is not there; base has failed: " + world.reason("base")), reason);
    assertEquals(List.of(), world.ports());
    world.awaitNoThread("Natalie.base");
    Eventually.await("no thread runs code of it", () -> threadsOfRos().isEmpty(), RosBundleTest::threadsOfRos);
    world.await("text", RuicState.SELECTED);
    world.awaitText("text", "base (ros)  failed: type 'ros' is not there");
  }

  /** Threads that run our ROS code, whatever they are called. */
  private static List<String> threadsOfRos() {
    return Thread.getAllStackTraces().entrySet().stream().filter(RosBundleTest::runsRos)
        .map(e -> e.getKey().getName()).sorted().toList();
  }

  private static boolean runsRos(Map.Entry<Thread, StackTraceElement[]> thread) {
    return Arrays.stream(thread.getValue()).map(StackTraceElement::getClassName)
        .anyMatch(c -> c.startsWith("org.robotui.ros.") || c.startsWith("org.robotui.rfic.ros."));
  }

  @Test
  void aStoppedBundleLeavesNothingAndConnectsAgainWhenItStarts() throws Exception {
    assertTrue(!threadsOfRos().isEmpty());

    Bundles.stop(World.ROS_RFIC);
    awaitLoss();

    Bundles.start(World.ROS_RFIC);
    awaitScans();
  }

  @Test
  void anUninstalledBundleConnectsAgainWhenItIsInstalledAnew() throws Exception {
    world.uninstall(World.ROS_RFIC);
    Bundles.refresh();
    awaitLoss();

    world.install(World.ROS_RFIC);
    awaitScans();
  }

  @Test
  void theLibraryBelowMayBeExchangedUnderTheRunningBundle() throws Exception {
    Bundles.refresh(World.ROS);
    awaitScans();
  }

  @Test
  void theLibraryBelowMayGoAndReturn() throws Exception {
    world.uninstall(World.ROS);
    Bundles.refresh();
    awaitLoss();

    world.install(World.ROS);
    Bundles.start(World.ROS_RFIC);
    awaitScans();
  }
}
