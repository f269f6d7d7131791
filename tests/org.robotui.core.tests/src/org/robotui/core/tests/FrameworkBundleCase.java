package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.RuicState;

/** A bundle that speaks a framework comes and goes while the simulated robot, one for all tests, goes on. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
abstract class FrameworkBundleCase {
  private final Framework framework;
  private @TempDir Path folder;
  private Simulator simulator;
  private World world;

  /**
   * What differs.
   *
   * @param type of the robot interface
   * @param library bundle below that of the robot interface
   * @param options of the simulator
   * @param scan its port with laser scans, a name
   * @param settings of the robot interface, from what the simulator says
   */
  record Framework(String type, String library, List<String> options, String scan, Addressed settings) {
    String bundle() {
      return "org.robotui.rfic." + type;
    }

    /** Makes settings from what the simulator says. */
    @FunctionalInterface
    interface Addressed {
      String of(Simulator simulator) throws IOException;
    }
  }

  FrameworkBundleCase(Framework framework) {
    this.framework = framework;
  }

  @BeforeAll
  void simulate() throws IOException {
    simulator = new Simulator(framework.options().toArray(String[]::new));
  }

  @AfterAll
  void endRobot() throws Exception {
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
              base: {type: %s, %s}
            uics:
              text: {unused: false}
            connect:
              text.all: base.%s
        """.formatted(framework.type(), framework.settings().of(simulator), framework.scan()));
    awaitScans();
  }

  @AfterEach
  void end() throws Exception {
    world.close();
  }

  private void awaitScans() {
    world.awaitMatch("text.all", m -> m.state() == MatchState.CONNECTED);
    Eventually.await("scans come",
        () -> world.port("base." + framework.scan()).filter(p -> p.rateHz() > 1 && !p.stale()).isPresent(),
        () -> world.port("base." + framework.scan()));
    world.awaitText("text", "LaserScan");
    world.awaitText("text", "base (" + framework.type() + ")  connected: ");
  }

  private void awaitLoss() {
    world.await("base", RuicState.FAILED);
    String why = "type '" + framework.type() + "' is not there; install or start bundle " + framework.bundle();
    Eventually.await("it is said why", () -> world.reason("base").equals(why), () -> world.reason("base"));
    world.awaitMatch("text.all", m -> m.state() == MatchState.PENDING
        && m.reason().endsWith("is not there; base has failed: " + why));
    Eventually.await("its ports are gone", () -> world.ports().isEmpty(), world::ports);
    world.awaitNoThread("Natalie.base");
    Eventually.await("no thread runs code of it", () -> ourThreads().isEmpty(), this::ourThreads);
    world.await("text", RuicState.SELECTED);
    world.awaitText("text", "base (" + framework.type() + ")  failed: type '" + framework.type() + "' is not there");
  }

  /** Threads that run our code for the framework, whatever they are called. */
  private List<String> ourThreads() {
    return Thread.getAllStackTraces().entrySet().stream().filter(this::runsOurs)
        .map(e -> e.getKey().getName()).sorted().toList();
  }

  private boolean runsOurs(Map.Entry<Thread, StackTraceElement[]> thread) {
    return Arrays.stream(thread.getValue()).map(StackTraceElement::getClassName)
        .anyMatch(c -> c.startsWith(framework.library() + ".") || c.startsWith(framework.bundle() + "."));
  }

  @Test
  void aStoppedBundleLeavesNothingAndConnectsAgainWhenItStarts() throws Exception {
    assertTrue(!ourThreads().isEmpty());

    Bundles.stop(framework.bundle());
    awaitLoss();

    Bundles.start(framework.bundle());
    awaitScans();
  }

  @Test
  void anUninstalledBundleConnectsAgainWhenItIsInstalledAnew() throws Exception {
    world.uninstall(framework.bundle());
    Bundles.refresh();
    awaitLoss();

    world.install(framework.bundle());
    awaitScans();
  }

  @Test
  void theLibraryBelowMayBeExchangedUnderTheRunningBundle() throws Exception {
    Bundles.refresh(framework.library());
    awaitScans();
  }

  @Test
  void theLibraryBelowMayGoAndReturn() throws Exception {
    world.uninstall(framework.library());
    Bundles.refresh();
    awaitLoss();

    world.install(framework.library());
    Bundles.start(framework.bundle());
    awaitScans();
  }
}
