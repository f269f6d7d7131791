package org.robotui.core.internal.compose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.SettingsGroup;
import org.robotui.api.host.SettingsGroup.Part;
import org.robotui.api.host.SettingsOutcome;
import org.robotui.api.port.Arity;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.data.sensor.LaserScan;

class WrittenSettingsTest {
  private static final String YAML = """
      # Two robots.
      ruics:
        Keira:
          rfics:
            base: {type: fake, peer: here}   # the only one
          uics:
            scan:
            more: {type: scan, title: Other}
          safety:
            Keira: {max_linear: 0.5}   # m/s
        Natalie:
          rfics: {base: fake}
          uics: {scan: {}}
      """;

  @TempDir
  Path folder;
  private CoreBench bench;

  @BeforeEach
  void load() {
    bench = new CoreBench(folder);
    bench.registry.add(new FakeRobot("fake"), "org.robotui.rfic.fake");
    bench.registry.add(new FakeView("scan", new StreamPort<>("scan", LaserScan.class, Arity.ONE, "")), "b");
    assertEquals(List.of(), bench.load(YAML));
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private SettingsGroup group(String ruic, Part part, String id) {
    return bench.core.settings().groups().stream()
        .filter(g -> g.ruic().equals(ruic) && g.part() == part && g.id().equals(id)).findFirst().orElseThrow();
  }

  private String text() throws IOException {
    return Files.readString(folder.resolve("test.yaml"));
  }

  private void written(SettingsGroup group, Map<String, Object> values, String... changed) {
    SettingsOutcome outcome = bench.core.settings().write(group, values);
    assertEquals(List.of(changed), assertInstanceOf(SettingsOutcome.Done.class, outcome, outcome::toString).changed());
  }

  private void refused(SettingsGroup group, Map<String, Object> values, String part) throws IOException {
    String before = text();
    SettingsOutcome outcome = bench.core.settings().write(group, values);
    String reason = assertInstanceOf(SettingsOutcome.Refused.class, outcome).reason();
    assertTrue(reason.contains(part), reason);
    assertEquals(before, text());
  }

  @Test
  void allThatCanBeSetIsListedWithWhatTheFileSaysAndWhere() {
    List<SettingsGroup> groups = bench.core.settings().groups();

    assertEquals(
        List.of("RUIC ", "INTERFACE base", "VIEW scan", "VIEW more", "CONNECTIONS ", "SAFETY Keira", "RUIC ",
            "INTERFACE base", "VIEW scan", "CONNECTIONS ", "SAFETY Natalie", "BRIDGES "),
        groups.stream().map(g -> g.part() + " " + g.id()).toList());
    assertEquals(Map.of("peer", "here"), groups.get(1).values());
    assertEquals(5, groups.get(1).line());
    assertEquals("Other", groups.get(3).title());
    assertEquals(List.of("scan.scan", "more.scan"),
        groups.get(4).schema().settings().stream().map(s -> s.name()).toList());
    assertEquals(Map.of("max_linear", "0.5"), groups.get(5).values());
    assertEquals(10, groups.get(5).line());
    assertEquals(11, groups.get(10).line(), "where it would be made");
  }

  @Test
  void whatIsChangedIsAllThatChangesInTheFile() throws IOException {
    written(group("Keira", Part.SAFETY, "Keira"), Map.of("max_linear", "0.25", "lease", false), "max_linear", "lease");
    assertEquals(YAML.replace("{max_linear: 0.5}", "{max_linear: 0.25, lease: false}"), text());
    written(group("Keira", Part.SAFETY, "Keira"), Map.of("max_linear", "0.5"), "max_linear", "lease");
    assertEquals(YAML, text());
    written(group("Keira", Part.INTERFACE, "base"), Map.of("peer", "here"));
    assertEquals(YAML, text());
  }

  @Test
  void sectionsThatAreNotThereAreMade() throws IOException {
    written(group("Natalie", Part.SAFETY, "Natalie"), Map.of("max_angular", "1"), "max_angular");
    written(group("Natalie", Part.INTERFACE, "base"), Map.of("peer", "there"), "peer");
    written(group("Keira", Part.CONNECTIONS, ""), Map.of("scan.scan", List.of("base.a", "base.b")), "scan.scan");
    written(group("Keira", Part.VIEW, "scan"), Map.of("title", "Laser: front"), "title");
    assertEquals(YAML.replace("scan:\n", "scan:\n        title: \"Laser: front\"\n")
        .replace("# m/s\n", "# m/s\n    connect:\n      scan.scan: [base.a, base.b]\n")
        .replace("{base: fake}", "{base: {type: fake, peer: there}}")
        + "    safety:\n      Natalie:\n        max_angular: 1\n", text());
  }

  @Test
  void bridgesAreAddedChangedRenamedAndRemovedByTheirFile() throws IOException {
    Map<String, Object> scan = Map.of("from", "Keira.scan", "to", "Natalie.keira");
    written(group("", Part.BRIDGES, ""), Map.of("bridges", Map.of("scan", scan)), "bridges");
    assertTrue(text().startsWith(YAML + "bridges:"), this::textNow);
    assertEquals(Map.of("bridges", Map.of("scan", scan)), group("", Part.BRIDGES, "").values());
    written(group("", Part.BRIDGES, ""), Map.of("bridges", Map.of("laser", scan)), "bridges");
    refused(group("", Part.BRIDGES, ""), Map.of("bridges", Map.of("laser", Map.of("from", "Keira.scan"))), "'to'");
    written(group("", Part.BRIDGES, ""), Map.of(), "bridges");
    assertEquals(YAML, text());
  }

  private String textNow() {
    try {
      return text();
    } catch (IOException e) {
      return e.toString();
    }
  }

  @Test
  void whatWouldBeAnErrorIsNotWritten() throws IOException {
    refused(group("Keira", Part.SAFETY, "Keira"), Map.of("max_linear", "1000"),
        "'max_linear' must be a number from 0 to 100 in m/s");
    refused(group("Keira", Part.CONNECTIONS, ""), Map.of("scan.scan", "bas.x"),
        "there is no robot interface 'bas'; did you mean 'base'?");
  }

  @Test
  void aFileThatSomebodyElseHasChangedIsLeftAlone() throws IOException {
    SettingsGroup group = group("Keira", Part.SAFETY, "Keira");
    Files.writeString(folder.resolve("test.yaml"), YAML + "# mine\n");
    refused(group, Map.of("max_linear", "0.25"), "was changed meanwhile");
    SettingsGroup now = group("Keira", Part.SAFETY, "Keira");
    Files.delete(folder.resolve("test.yaml"));
    assertInstanceOf(SettingsOutcome.Refused.class, bench.core.settings().write(now, Map.of()));
  }

  @Test
  void aTemplateIsLeftToAnEditor() throws IOException {
    Files.writeString(folder.resolve("test.yaml"),
        "ruics:\n  ${robot}: {for: r1..r2, rfics: {base: fake}, uics: {scan: {}}}\n");
    SettingsGroup group = group("r2", Part.SAFETY, "r2");
    assertEquals(2, group.line());
    refused(group, Map.of("max_linear", "1"), "test.yaml:2: 'r2' may be formed by the template there (for:)");
  }
}
