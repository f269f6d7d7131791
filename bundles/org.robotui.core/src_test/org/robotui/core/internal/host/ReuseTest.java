package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.host.ReuseReport.Kind;
import org.robotui.api.host.ReuseReport.Pair;
import org.robotui.api.host.ReuseReport.Row;
import org.robotui.api.layout.Layout;
import org.robotui.core.internal.config.SchemaCheck;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.life.Plan;
import org.robotui.core.internal.life.Registry;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.core.internal.watch.BundleNames;

class ReuseTest {
  private static final Map<String, Set<String>> WIRES = Map.of(
      "org.robotui.uic.map", Set.of("org.robotui.entity.laserscan", "org.robotui.data", "org.eclipse.swt"),
      "org.robotui.entity.laserscan", Set.of("org.robotui.data"),
      "org.robotui.rfic.ros", Set.of("org.robotui.ros", "org.robotui.data"),
      "org.robotui.data", Set.of("org.robotui.core", "org.robotui.data"));

  private final Registry registry = new Registry();
  private final SchemaCheck check = new SchemaCheck();
  private final Reuse reuse = new Reuse(registry, new BundleNames() {
    @Override
    public Optional<String> bundleOf(String className) {
      return Optional.empty();
    }

    @Override
    public Set<String> usedBy(String bundle) {
      return WIRES.getOrDefault(bundle, Set.of());
    }
  });

  ReuseTest() {
    registry.add(new FakeRobot("ros"), "org.robotui.rfic.ros");
    registry.add(new FakeRobot("player"), "org.robotui.rfic.player");
    registry.add(new FakeView("map"), "org.robotui.uic.map");
    registry.add(new FakeView("plot"), "org.robotui.uic.plot");
  }

  private ComponentConfig component(String type) {
    return new ComponentConfig(type, type, "", "r", check.nothing(), "f", 1, 1);
  }

  private void add(String name, String framework, String... views) {
    List<ComponentConfig> uics = List.of(views).stream().map(this::component).toList();
    reuse.add(new RuicConfig(name, "f", 1, 1, "", check.nothing(), List.of(component(framework)), List.of(), uics,
        List.of(), Optional.empty(),
        Map.of(), Map.of(), List.of(), false), new Plan(Optional.empty(), uics, new Layout.Tabs(List.of())));
  }

  @Test
  void countsWhatIsSharedDownToWhatItIsBuiltOn() {
    add("Natalie", "ros", "map");
    add("Keira", "player", "map", "plot");
    ReuseReport report = reuse.report();
    assertEquals(List.of(
        new Row(Kind.RFIC, "org.robotui.rfic.player", "Fake robot", List.of("Keira")),
        new Row(Kind.RFIC, "org.robotui.rfic.ros", "Fake robot", List.of("Natalie")),
        new Row(Kind.UIC, "org.robotui.uic.map", "Fake view", List.of("Natalie", "Keira")),
        new Row(Kind.UIC, "org.robotui.uic.plot", "Fake view", List.of("Keira")),
        new Row(Kind.ENTITY, "org.robotui.entity.laserscan", "laserscan", List.of("Natalie", "Keira")),
        new Row(Kind.BASE, "org.robotui.data", "data", List.of("Natalie", "Keira")),
        new Row(Kind.BASE, "org.robotui.ros", "ros", List.of("Natalie"))), report.rows());
    assertEquals(List.of(new Pair("Natalie", "Keira", 3, 2, 2)), report.pairs());
    assertEquals("Natalie and Keira share 3 of 7 bundles", report.summary());
  }

  @Test
  void canBeWrittenAsTables() {
    add("Nat|alie", "ros", "map");
    add("Keira, 2", "ros");
    String markdown = reuse.report().markdown();
    assertTrue(markdown.startsWith("| kind | bundle | Nat\\|alie | Keira, 2 | used by |\n|---|---|:-:|:-:|--:|\n"
        + "| rfic | `org.robotui.rfic.ros` | x | x | 2 |\n"), markdown);
    assertTrue(markdown.endsWith("| Nat\\|alie | Keira, 2 | 3 | 2 | 0 |\n"), markdown);
    String csv = reuse.report().csv();
    assertTrue(csv.startsWith(
        "kind,bundle,name,\"Nat|alie\",\"Keira, 2\",used_by\nrfic,org.robotui.rfic.ros,Fake robot,1,1,2\n"), csv);
  }

  @Test
  void withoutRobotsThereIsNothing() {
    assertEquals("no robot UI runs", reuse.report().summary());
    assertEquals(List.of(), reuse.report().pairs());
  }
}
