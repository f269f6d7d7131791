package org.robotui.core.internal.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.Problem;
import org.robotui.api.layout.Layout;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ConfigResult;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.testkit.Effort;

class YamlConfigSourceTest {
  private static final String GOOD = """
      ruics:
        Natalie:
          type: base
          rfics:
            ros: {type: ros, master: "${MASTER}"}
          uics:
            map: {follow: true}
            extra: {type: camera, title: Front}
          connect:
            map.scan: [ros.scan, ros.scan_rear]
            extra.image: none
          layout:
            row:
              - {view: map, weight: 2}
              - column: [{tabs: [extra, camera], front: camera}]
          perspectives: {Look: {tabs: [extra, camera]}, Drive: map}
          safety:
            Natalie: {max_linear: 0.5, stop_call: {interface: ros, service: /stop}}
      """;

  @TempDir
  Path folder;

  @Test
  void readsEverythingThatAConfigurationMaySay() throws IOException {
    ConfigResult result = read(GOOD);
    assertEquals(List.of(), result.problems());
    RuicConfig ruic = result.ruics().getFirst();
    assertEquals("Natalie", ruic.rfics().getFirst().robot());
    assertEquals(List.of("", "camera"), ruic.uics().stream().map(u -> u.type()).toList());
    assertEquals("Front", ruic.uics().get(1).title());
    assertEquals(List.of(new SourceId("ros", "scan"), new SourceId("ros", "scan_rear")),
        ruic.connections().getFirst().peers());
    assertEquals(List.of(), ruic.connections().get(1).peers());
    assertEquals(0.5, ruic.safety("Natalie").limits().linear());
    assertEquals("/stop", ruic.safety("Natalie").stopCall().orElseThrow().request().service());
    Layout.Split split = (Layout.Split) ruic.layout().orElseThrow();
    assertEquals(List.of(2.0, 1.0), split.weights());
    assertEquals(new Layout.Tabs(List.of("extra", "camera"), 1), split.parts().getLast());
    assertEquals(Map.of("Look", new Layout.Tabs(List.of("extra", "camera")), "Drive", new Layout.View("map")),
        ruic.perspectives());
  }

  @Test
  void viewsThatATypeNotInstalledWouldBringMayBeNamed() throws IOException {
    ConfigResult result = read(GOOD.replace("type: base", "type: later"));
    assertEquals(List.of("no RUIC type 'later' is installed; valid are base"),
        result.problems().stream().map(Problem::message).toList());
    RuicConfig ruic = result.ruics().getFirst();
    assertEquals("", ruic.uics().getFirst().type(), "the type of a view that it may bring is its own");
    assertEquals(2, ruic.connections().size());
    assertTrue(ruic.layout().isPresent());
  }

  @Test
  void namesLineColumnAndNearestWord() throws IOException {
    assertProblem(GOOD.replace("{follow: true}", "{}").replace("type: camera", "type: camra"),
        8, 21, "no view type 'camra' is installed; did you mean 'camera'?");
    assertProblem(GOOD.replace("title: Front", "titel: Front"), 8, 29, "unknown setting 'titel'");
    assertProblem(GOOD.replace("layout:", "layuot:"), 12, 5, "did you mean 'layout'?");
    assertProblem(GOOD.replace("front: camera", "front: map"), 15, 51,
        "'front' must be one of its tabs: extra, camera");
    assertProblem(GOOD.replace("[extra, camera], front: camera", "[extra, map]"), 13, 7, "'map' has two places");
    assertProblem(GOOD.replace("Drive: map", "Drive: mpa"), 16, 58, "there is no view 'mpa'; did you mean 'map'?");
    assertProblem(GOOD.replace("view: map", "view: mpa"), 14, 18, "there is no view 'mpa'; did you mean 'map'?");
    assertProblem(GOOD.replace("[ros.scan,", "[rso.scan,"), 10, 18,
        "there is no robot interface 'rso'; did you mean 'ros'?");
    assertProblem(GOOD.replace("max_linear: 0.5", "max_linear: fast"), 18, 29,
        "'max_linear' must be a number from 0 to 100 in m/s, not 'fast'");
    assertProblem(GOOD.replace("ruics:", "ruisc:"), 1, 1, "did you mean 'ruics'?");
    assertProblem(GOOD.replace("weight: 2", "weight: -2"), 14, 31, "'weight' must be a number from 0.01 to 1000");
    assertProblem(GOOD.replace("    Natalie: {max", "    Natalia: {max"), 18, 7, "did you mean 'Natalie'?");
  }

  @Test
  void readsWhichWindowsAreOpened() throws IOException {
    assertEquals(List.of(), read(GOOD).windows());
    assertEquals(List.of("Natalie 1.0"), windows("windows: Natalie\n" + GOOD));
    assertEquals(List.of("Keira 1.0", "Natalie 2.0"),
        windows("windows: [Keira, {show: Natalie, weight: 2}]\n" + GOOD
            + "  Keira: {type: base, rfics: {b: {type: ros, master: x}}}\n"));
  }

  private List<String> windows(String text) throws IOException {
    ConfigResult result = read(text);
    assertEquals(List.of(), result.problems());
    return result.windows().stream().map(w -> w.ruic() + " " + w.weight()).toList();
  }

  @Test
  void saysWhatIsWrongWithWindowsAndTheRobotsRunAllTheSame() throws IOException {
    assertProblem("windows: [Natlie]\n" + GOOD, 1, 11,
        "there is no RUIC 'Natlie' for a window; did you mean 'Natalie'?");
    assertProblem("windows: [Natalie, Natalie]\n" + GOOD, 1, 20, "'Natalie' has a window already");
    assertProblem("windows: [{weight: 2}]\n" + GOOD, 1, 11,
        "'show' is missing: the name of a RUIC, such as {show: Natalie, weight: 2}");
    assertProblem("windows: [{show: Natalie, weight: -1}]\n" + GOOD, 1, 35,
        "'weight' must be a number from 0.01 to 1000, not '-1'");
    assertProblem("windows: [{show: Natalie, wieght: 1}]\n" + GOOD, 1, 27, "did you mean 'weight'?");
    assertProblem("windows: [[Natalie]]\n" + GOOD, 1, 11, "not a list");
    assertProblem("windows:\n" + GOOD, 1, 9, "a window must be the name of a RUIC, such as Natalie, not nothing");
    assertProblem("windows: [" + "x, ".repeat(16) + "x]\n" + GOOD, 1, 10, "write at most 16");
    assertEquals(1, read("windows: [Natlie]\n" + GOOD).ruics().size());
  }

  @Test
  void findsSlipsAlsoWhereTheTypeIsNotInstalled() throws IOException {
    String text = GOOD.replace("type: base", "type: bsae").replace("connect:", "conect:");
    assertProblem(text, 3, 11, "no RUIC type 'bsae' is installed; did you mean 'base'?");
    assertProblem(text, 9, 5, "did you mean 'connect'?");
  }

  @Test
  void whatATypeFindsFaultWithHasItsPlace() throws IOException {
    assertProblem(GOOD.replace("master: ", "folder: maps, master: "), 5,
        GOOD.lines().toList().get(4).indexOf("master: ") + 9,
        "no folder " + folder.toAbsolutePath().resolve("maps"));
  }

  @Test
  void saysWhichVariableIsNotSet() throws IOException {
    assertProblem(GOOD.replace("${MASTER}", "${NOWHERE}"), 5, 32, "NOWHERE is not set");
    assertEquals(List.of(), read(GOOD.replace("${MASTER}", "${NOWHERE:-http://here:1}")).problems());
  }

  @Test
  void keepsGoodRuicsBesideABrokenOne() throws IOException {
    ConfigResult result = read(GOOD + "  Broken: {type: base}\n");
    assertEquals(1, result.problems().size());
    assertEquals(List.of("Natalie"), result.ruics().stream().map(RuicConfig::name).toList());
  }

  @Test
  void refusesWhatIsNoYamlWithAPlace() throws IOException {
    assertProblem("ruics:\n  a: [1, 2\n  b: }", 3, 4, "this is no YAML");
    assertProblem("ruics: {a: 1, a: 2}", 1, 15, "stands here twice; the first is in line 1");
    assertProblem("- a\n- b\n", 1, 1, "must be a section of names and values, not a list");
    assertProblem("", 1, 1, "'ruics' is missing");
  }

  @Test
  void boundsAliasBombs() throws IOException {
    StringBuilder bomb = new StringBuilder("a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n");
    for (int i = 1; i < 12; i++) {
      String each = "*a" + (i - 1) + ", ";
      bomb.append("a").append(i).append(": &a").append(i).append(" [").append(each.repeat(9)).append("x]\n");
    }
    assertProblem(bomb.toString(), 1, 1, "Number of aliases");
    assertProblem("ruics: &r {a: *r}", 1, 1, "endless or too large");
  }

  @Test
  void saysWhenThereIsNoFileAndWhichOneMayBeMeant() throws IOException {
    Files.writeString(folder.resolve("demo.yaml"), GOOD);
    ConfigResult result = source().read(folder.resolve("dmeo.yaml"), new FakeTypes());
    assertTrue(result.problems().getFirst().message().contains("did you mean 'demo.yaml'?"));
  }

  @Test
  void survivesAnyMutation() throws IOException {
    RandomGenerator random = RandomGenerator.of("L64X128MixRandom");
    for (Effort effort = Effort.of(2_000, Duration.ofMinutes(5)); effort.goesOn();) {
      StringBuilder text = new StringBuilder(GOOD);
      for (int edit = 0; edit < 3; edit++) {
        int at = random.nextInt(text.length());
        text.replace(at, Math.min(text.length(), at + random.nextInt(4)), mutation(random));
      }
      ConfigResult result = read(text.toString());
      assertTrue(!result.ruics().isEmpty() || !result.problems().isEmpty(), text.toString());
    }
  }

  private static String mutation(RandomGenerator random) {
    String[] pieces =
        {"", ":", "{", "}", "[", "]", "- ", "\n", "&a ", "*a", "!!int ", "\t", "\"", "\u0000", "999999999999", "  "};
    return pieces[random.nextInt(pieces.length)];
  }

  private YamlConfigSource source() {
    return new YamlConfigSource(Map.of("MASTER", "http://127.0.0.1:11311"));
  }

  private ConfigResult read(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("test.yaml"), text);
    return source().read(file, new FakeTypes());
  }

  private void assertProblem(String text, int line, int column, String part) throws IOException {
    List<Problem> problems = read(text).problems();
    assertTrue(
        problems.stream().anyMatch(p -> p.line() == line && p.column() == column && p.message().contains(part)),
        () -> "expected " + line + ":" + column + " " + part + " among " + problems);
  }
}
