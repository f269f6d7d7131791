package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.core.internal.support.Samples;

class CheckerTest {
  private static final String YAML = """
      ruics:
        pioneer:
          rfics:
            base: {type: fake}
          uics:
            map: {type: map}
            grid: {type: grid}
      """;

  @TempDir
  Path folder;

  private CoreBench bench;
  private final FakeRobot robot = new FakeRobot("fake").ports(Samples.SCAN);

  @BeforeEach
  void start() {
    bench = new CoreBench(folder);
    bench.registry.add(robot, "org.robotui.rfic.fake");
    bench.registry.add(new FakeView("map", Samples.SCAN), "org.robotui.uic.map");
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private CheckReport check(String yaml, Duration wait) {
    return bench.core.check(bench.write(yaml), wait);
  }

  @Test
  void saysWhatWouldBeConnectedWithoutCreatingAnything() {
    bench.registry.add(new FakeView("grid", Samples.MAP), "org.robotui.uic.grid");
    CheckReport report = check(YAML, Duration.ZERO);
    assertTrue(report.usable());
    Match scan = report.matches().get("pioneer").get(0);
    Match grid = report.matches().get("pioneer").get(1);
    assertEquals(MatchState.CONNECTED, scan.state());
    assertEquals(MatchState.PENDING, grid.state());
    assertTrue(grid.reason().contains("base will say what it has when it runs"), grid.reason());
    assertEquals(0, robot.contexts.size());
    assertEquals(0, bench.core.ruics().size());
  }

  @Test
  void waitsForTypesThatAppear() throws InterruptedException {
    Thread late = Thread.ofPlatform().start(
        () -> bench.registry.add(new FakeView("grid", Samples.MAP), "org.robotui.uic.grid"));
    CheckReport report = check(YAML, Duration.ofSeconds(10));
    late.join();
    assertEquals(2, report.matches().get("pioneer").size());
  }

  @Test
  void waitsNoLongerThanItMay() {
    long start = System.nanoTime();
    check(YAML, Duration.ofMillis(50));
    assertTrue(System.nanoTime() - start < 5_000_000_000L);
  }

  @Test
  void brokenFileIsNotUsable() {
    assertFalse(check("ruics: [", Duration.ofMillis(10)).usable());
  }
}
