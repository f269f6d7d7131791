package org.robotui.core.internal.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.Problem;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.ConfigResult;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.data.FrameId;

class TemplatesTest {
  private static final String SWARM = """
      ruics:
        team:
          type: base
          rfics:
            ${robot}: {for: r1..r3, type: ros, robot: "${robot}", master: "http://${robot}:1131${number}"}
          frames:
            - {for: r2..r3, parent: r1/map, child: "${robot}/map", x: "${number}"}
          safety:
            ${robot}: {for: r1..r3, max_linear: 0.5}
        "${robot}":
          for: [r1..r2, leader]
          type: base
          start: when_shown
          rfics:
            base: {type: ros, master: "${robot}/${number}"}
      """;

  @TempDir
  Path folder;

  @Test
  void aTemplateIsFormedForEachName() throws IOException {
    ConfigResult result = read(SWARM);
    assertEquals(List.of(), result.problems());
    assertEquals(List.of("team", "r1", "r2", "leader"), names(result));
    RuicConfig team = result.ruics().getFirst();
    assertEquals(List.of("r1", "r2", "r3"), team.rfics().stream().map(ComponentConfig::id).toList());
    assertEquals("http://r3:11313", setting(team.rfics().get(2), "master"));
    assertEquals(0.5, team.safety("r2").limits().linear());
    assertEquals(new FrameId("r3", "map"), team.frames().get(1).child());
    assertEquals(3, team.frames().get(1).parentFromChild().translation().x());
    RuicConfig leader = result.ruics().get(3);
    assertEquals("leader/3", setting(leader.rfics().getFirst(), "master"), "its place where the name has no number");
    assertEquals("leader", leader.rfics().getFirst().robot());
    assertTrue(leader.startsShown());
  }

  @Test
  void rangesKeepTheirZeros() throws IOException {
    ConfigResult result = read(ruic("for: r08..r11"));
    assertEquals(List.of("r08", "r09", "r10", "r11"), names(result));
    assertEquals("8", setting(result.ruics().getFirst().rfics().getFirst(), "master"));
  }

  @Test
  void namesMayComeFromTheEnvironment() throws IOException {
    assertEquals(List.of("a", "b"), names(read(ruic("for: \"${ROBOTS}\""))));
  }

  @Test
  void mistakesNamePlaceAndRobotOnce() throws IOException {
    String wrong = ruic("for: r1..r50").replace("master:", "mastre:");
    assertEquals(List.of("4:20: unknown setting 'mastre'; did you mean 'master'? (for r1 and 49 more)",
        "4:19: 'master' is missing: a text (the master) (for r1 and 49 more)"), told(wrong));
  }

  @Test
  void whatIsNoListOfNamesIsRefused() throws IOException {
    assertTrue(told(ruic("for: r5..r1")).getFirst().startsWith("3:10: 'r5..r1' is no range"));
    assertTrue(told(ruic("for: r1..r999999999")).getFirst().contains("at most 1000"));
    assertTrue(told(ruic("for: [a, a]")).getFirst().contains("'a' is named twice"));
    assertTrue(told(ruic("for: [a, ]").replace("[a, ]", "\"a,,b\"")).getFirst().contains("names nobody"));
    assertEquals(1, told(ruic("for: [a..b]")).size());
  }

  @Test
  void theNameOfATemplateMustDiffer() throws IOException {
    String same = ruic("for: r1..r3").replace("${robot}:\n", "fixed:\n");
    assertEquals(List.of(
        "2:3: 'fixed' stands here twice; write ${robot} or ${number} in the name of the template (for r2 and 1 more)"),
        told(same));
  }

  @Test
  void outsideOfTemplatesNothingIsMeantByIt() throws IOException {
    List<String> told = told("ruics: {x: {type: base, rfics: {base: {type: ros, master: \"${robot}\"}}}}");
    assertTrue(told.getFirst().contains("only in a section that says 'for:'"), told.toString());
  }

  @Test
  void aNumberIsASettingOfTheSameName() throws IOException {
    ConfigResult result = read("""
        ruics:
          x:
            type: base
            rfics: {base: {type: ros, master: m}}
            uics: {plan: {type: map, for: 5}}
        """);
    assertTrue(result.problems().getFirst().message().startsWith("unknown setting 'for'"),
        result.problems().toString());
  }

  @Test
  void expansionIsBounded() throws IOException {
    StringBuilder deep = new StringBuilder("ruics: {a: {type: base, rfics: {base: ros}, uics: {map: ");
    IntStream.range(0, 5).forEach(i -> deep.append("{'x${robot}': {for: 'r1..r1000', y: "));
    deep.append("1").append("}}".repeat(5)).append("}}}");
    assertTrue(told(deep.toString()).stream().anyMatch(m -> m.contains("endless or too large")));
  }

  private static String ruic(String names) {
    return """
        ruics:
          ${robot}:
            %s
            rfics: {base: {master: "${number}", type: ros}}
            type: base
        """.formatted(names);
  }

  private static Object setting(ComponentConfig component, String name) {
    return ((YamlValue.Scalar) ((WrittenSection) component.raw()).section().get(name).orElseThrow()).text();
  }

  private static List<String> names(ConfigResult result) {
    assertEquals(List.of(), result.problems());
    return result.ruics().stream().map(RuicConfig::name).toList();
  }

  private List<String> told(String text) throws IOException {
    return read(text).problems().stream().map(this::words).toList();
  }

  private String words(Problem problem) {
    return problem.line() + ":" + problem.column() + ": " + problem.message();
  }

  private ConfigResult read(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("f.yaml"), text);
    return new YamlConfigSource(Map.of("ROBOTS", "a, b")).read(file, new FakeTypes());
  }
}
