package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.ConfigChange.Step;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.Ruic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Demand;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.core.internal.support.Samples;
import org.robotui.testkit.MachineLoad;

class ConfigChangeTest {
  private static final String YAML = """
      ruics:
        pioneer:
          rfics:
            base: {type: fake, peer: first}
          uics:
            map: {zoom: 3}
          connect:
            map.scan: base.scan
      """;

  @TempDir
  Path folder;

  private CoreBench bench;
  private final List<ConfigChange> changes = new CopyOnWriteArrayList<>();

  @BeforeEach
  void start() {
    bench = new CoreBench(folder);
    for (String id : List.of("fake", "other")) {
      bench.registry.add(new FakeRobot(id).onStart(c -> {
        c.offers().stream(Samples.SCAN, Demand.IGNORED);
        c.link().report(new LinkState.Connected("robot"));
      }), "org.robotui.rfic." + id);
    }
    bench.registry.add(new FakeView("map", Samples.SCAN), "org.robotui.uic.map");
    bench.core.listen(new HostListener() {
      @Override
      public void configurationChanged(ConfigChange change) {
        changes.add(change);
      }
    });
    assertEquals(List.of(), bench.load(YAML));
    bench.ruic();
  }

  @AfterEach
  void end() {
    bench.close();
  }

  /** What is told of a change, at most two seconds after it. */
  private ConfigChange after(String yaml) {
    int before = changes.size();
    bench.write(yaml);
    long at = System.nanoTime();
    Await.until("the change is told", () -> changes.size() > before);
    long millis = (System.nanoTime() - at) / 1_000_000;
    assertTrue(millis < 2000 * MachineLoad.factor(), "it took " + millis + " ms");
    return changes.getLast();
  }

  @Test
  void sameNameTwiceIsAProblem() throws Exception {
    assertEquals(List.of(), bench.load(YAML), "the same file read again brings nothing new");
    Path other = Files.writeString(folder.resolve("other.yaml"), YAML);
    assertTrue(bench.core.load(other).getFirst().message().contains("runs already"));
    assertEquals(1, bench.core.ruics().size());
  }

  @Test
  void anotherFrameworkIsToldAndNotTakenUpByItself() {
    ConfigChange change = after(YAML.replace("type: fake, peer: first", "type: other, peer: second"));
    InterfaceConfig wanted = new InterfaceConfig("base", "other", "pioneer", "", Map.of("peer", "second"));
    assertEquals(List.of(), change.problems());
    assertEquals(List.of(new Step.Exchanged("pioneer", wanted)), change.steps());
    assertEquals("fake", bench.status("base").type());
  }

  @Test
  void aRestartTakesUpWhatTheFileSays() throws Exception {
    ConfigChange change = after(YAML.replace("fake", "other").replace("zoom: 3", "zoom: 4"));
    assertEquals(new Step.NeedsRestart("pioneer", "uics"), change.steps().getLast());
    bench.core.ruics().getFirst().restart().toCompletableFuture().get();
    assertEquals("other", bench.status("base").type());
  }

  @Test
  void mistakesAreToldWithTheirPlaceAndWhatRunsGoesOn() {
    ConfigChange change = after(YAML.replace("peer: first", "per: first"));
    assertEquals(4, change.problems().getFirst().line());
    assertTrue(change.problems().getFirst().message().contains("did you mean 'peer'"), change.problems().toString());
    assertEquals(List.of(), change.steps());
    assertEquals("fake", bench.status("base").type());
    ConfigChange mended = after(YAML);
    assertEquals(new ConfigChange(mended.file(), List.of(), List.of()), mended);
    assertEquals(1, bench.core.ruics().size());
  }

  @Test
  void aFileThatIsGoneIsToldAndWhatRunsGoesOn() throws Exception {
    Files.delete(folder.resolve("test.yaml"));
    Await.until("it is told", () -> !changes.isEmpty());
    assertTrue(changes.getFirst().problems().getFirst().message().contains("there is no such file"));
    assertEquals(1, bench.core.ruics().size());
    assertEquals(List.of(), after(YAML).steps(), "it is back, as it was");
  }

  @Test
  void aFileThatIsReplacedByAnotherOfTheSameSizeIsNoticed() throws Exception {
    Path fresh = Files.writeString(folder.resolve("fresh"), YAML.replace("first", "third"));
    Files.setLastModifiedTime(fresh, Files.getLastModifiedTime(folder.resolve("test.yaml")));
    Files.move(fresh, folder.resolve("test.yaml"), StandardCopyOption.REPLACE_EXISTING);
    Await.until("it is told", () -> !changes.isEmpty());
    assertEquals(1, changes.getFirst().steps().size());
  }

  @Test
  void aCommentChangesNothing() {
    assertEquals(List.of(), after("# a comment\n" + YAML).steps());
  }

  @Test
  void namedConnectionsAndSafetyAreTakenUpWhileItRuns() {
    Await.until("it is connected", () -> state() == MatchState.CONNECTED);
    ConfigChange change = after(
        YAML.replace("map.scan: base.scan", "map.scan: none") + "    safety:\n      pioneer: {max_linear: 0.1}\n");
    assertEquals(List.of(new Step.TakenUp("pioneer", "connect, safety")), change.steps());
    Await.until("it is left unconnected", () -> state() == MatchState.REFUSED);
    assertEquals(0.1, bench.core.ruics().getFirst().authorities().getFirst().limits().linear());
  }

  private MatchState state() {
    return bench.match("map.scan").orElseThrow().state();
  }

  @Test
  void newOnesAreStartedAndThoseThatAreGoneGoOn() {
    ConfigChange change = after(YAML.replace("pioneer", "husky"));
    assertEquals(List.of(new Step.Added("husky"), new Step.Gone("pioneer")), change.steps());
    assertEquals(List.of("pioneer", "husky"), bench.core.ruics().stream().map(Ruic::name).toList());
  }
}
