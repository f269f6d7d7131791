package org.robotui.core.tests;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.osgi.framework.Bundle;
import org.osgi.util.tracker.ServiceTracker;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.bridge.Bridges;
import org.robotui.data.command.VelocityCommand;
import org.robotui.testkit.osgi.PackedBundle;

/** A bridge whose transform is brought by a bundle that neither of its robots, nor the bridges, know. */
class BridgeTransformTest {
  private static final String BRIDGE = "org.robotui.bridge";
  private static final String NAME = "org.robotui.tests.crawl";
  private static final String IMPORTS = "org.osgi.framework,org.robotui.api.bridge,org.robotui.data,"
      + "org.robotui.data.command,org.robotui.data.sensor,org.robotui.geometry";
  private static final String YAML = """
      bridges:
        follow: {from: Natalie.battery, to: Keira.cmd_vel, transform: crawl}
      ruics:
        Natalie:
          rfics: {base: leads}
          uics: {words: text}
        Keira:
          rfics: {base: follows}
          uics: {words: text}
      """;

  private final Wheels keira = new Wheels("follows");
  private @TempDir Path folder;
  private World world;
  private ServiceTracker<Bridges, Bridges> bridges;

  @BeforeEach
  void load() throws Exception {
    world = new World(folder);
    world.bring(new FakeRobot("leads"));
    world.bring(keira);
    world.load(YAML);
    Bundles.start(BRIDGE);
    bridges = new ServiceTracker<>(Bundles.context(), Bridges.class, null);
    bridges.open();
    Eventually.await("there are bridges", () -> bridges.getService() != null, () -> "none");
    bridges.getService().start();
  }

  @AfterEach
  void end() throws Exception {
    bridges.getService().stop();
    bridges.close();
    world.close();
  }

  private void await(State state, String text) {
    Eventually.await("the bridge is " + state,
        () -> status().filter(s -> s.state() == state && s.text().contains(text)).isPresent(), this::status);
  }

  private Optional<BridgeStatus> status() {
    return bridges.getService().statuses().stream().findFirst();
  }

  @Test
  void aBridgeWaitsForTheBundleOfItsTransformAndForItsReturn() throws Exception {
    await(State.WRONG, "no transform 'crawl' is installed; there are: pose_goal");

    Bundle bundle = new PackedBundle(Bundles.context().getBundle(), NAME,
        Map.of("Import-Package", IMPORTS, "Bundle-Activator", NAME + ".CrawlActivator")).install();
    try {
      await(State.CARRYING, "carrying");
      Eventually.await("it drives as the transform has it",
          () -> keira.commands().stream().anyMatch(c -> c.value().equals(VelocityCommand.planar(0.5, 0))),
          keira::commands);

      bundle.stop();
      await(State.WRONG, "no transform 'crawl' is installed");
      keira.awaitStopped();

      bundle.start();
      await(State.CARRYING, "carrying");
      keira.awaitMoving();
    } finally {
      bundle.uninstall();
    }
    await(State.WRONG, "no transform 'crawl' is installed");
    keira.awaitStopped();
  }
}
