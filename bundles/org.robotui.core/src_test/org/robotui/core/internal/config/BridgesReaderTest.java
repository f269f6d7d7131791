package org.robotui.core.internal.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.host.Problem;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ConfigResult;

class BridgesReaderTest {
  private static final String ROBOTS = """
      ruics:
        Natalie: {type: base, rfics: {ros: {type: ros, master: here}}}
        Keira: {type: base, rfics: {ros: {type: ros, master: here}, arm: {type: ros, master: here}}}
        Dr. No: {type: base, rfics: {ros: {type: ros, master: here}}}
      bridges:
      """;

  private static ConfigResult read(String bridges) {
    return new YamlConfigSource(Map.of()).read(Path.of("test.yaml"), ROBOTS + bridges.indent(2), new FakeTypes());
  }

  private static String only(String bridges) {
    List<Problem> problems = read(bridges).problems();
    assertEquals(1, problems.size(), problems::toString);
    return problems.getFirst().line() + ":" + problems.getFirst().column() + " " + problems.getFirst().message();
  }

  @Test
  void endsArePortsOfRobotInterfaces() {
    ConfigResult result = read("""
        scan: {from: Natalie./scan, to: Keira.arm.natalie/scan, rate: 5, frames: {map: other/map}}
        goal: {from: Dr. No.goal, to: "Keira.ros.position2d:0"}
        """);
    assertEquals(List.of(), result.problems());
    BridgeConfig scan = result.bridges().getFirst();
    assertEquals("Natalie", scan.from().ruic());
    assertEquals(new SourceId("ros", "scan"), scan.from().port());
    assertEquals(new SourceId("arm", "natalie/scan"), scan.to().port());
    assertEquals(5, scan.settings().number("rate"));
    assertEquals(6, scan.line());
    assertEquals("Dr. No", result.bridges().getLast().from().ruic());
    assertEquals(new SourceId("ros", "position2d:0"), result.bridges().getLast().to().port());
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
      "a: {from: Natalia.scan, to: Keira.ros.scan} | 6:13 there is no robot UI 'Natalia' for a bridge; did you mean 'Natalie'?",
      "a: {from: Natalie.scan, to: Keira.scan} | 6:31 'Keira' has several robot interfaces; write which of them is meant, such as Keira.ros.scan",
      "a: {from: Natalie.scan} | 6:6 'to' is missing",
      "a: {from: Natalie, to: Keira.ros.scan} | 6:13 'from' must be a port of a robot, such as Natalie.scan",
      "a: {from: Natalie.scan, to: Keira.ros.scan, rat: 5} | 6:47 unknown setting 'rat'; did you mean 'rate'?",
      "a: {from: Natalie.scan, to: Keira.ros.scan, rate: 0} | 6:53 'rate' must be",
      "a: {from: Natalie.scan, to: Keira.ros.scan, fields: {x: 'y *'}} | 6:59 'fields.x' must be the path of a field",
      "a: {from: Natalie.scan, to: Natalie.ros.scan} | 6:3 the bridge 'a' leads from Natalie.ros.scan to where it begins",
      "a: {from: Natalie.x, to: Keira.ros.x, both: yes, fields: {x: y}} | 6:3 the bridge 'a' goes both ways, but its 'fields' go one way",
      "a: {from: Natalie.x, to: Keira.ros.x, transform: t, fields: {x: y}} | 6:3 the bridge 'a' has both 'fields' and a 'transform'",
      "a: {from: Natalie.x, to: Keira.ros.x, kind: service, both: yes} | 6:3 the bridge 'a' offers a service, which goes one way",
      "a: {from: Natalie.x, to: Keira.ros.x, kind: service, rate: 5} | 6:3 the bridge 'a' offers a service, and 'rate' is for values",
      "a: {from: Natalie.x, to: Keira.ros.x, reply: {x: y}} | 6:3 the bridge 'a' carries values, and 'reply' is for services",
      "a: {from: Natalie.x, to: Keira.ros.x, kind: service, feedback: {x: y}} | 6:3 the bridge 'a' offers a service, and 'feedback' is for actions",
      "a: {from: Natalie.x, to: Keira.ros.x, kind: action, both: yes} | 6:3 the bridge 'a' offers an action, which goes one way",
      "a: {from: Natalie.x, to: Keira.ros.x, kind: action, keep: all} | 6:3 the bridge 'a' offers an action, and 'keep' is for values",
      "a: {from: Natalie.x, to: Keira.ros.x, kind: parameter, rate: 5} | 6:3 the bridge 'a' keeps a parameter equal, and 'rate' does not go",
      "a: {from: Natalie.x, to: Keira.ros.x, when: x charge < low} | 6:3 the bridge 'a' has a 'when' that cannot be read: 'low' is no number",
      "a: {from: Natalie.x, to: Keira.ros.x, when: y charge < 1} | 6:3 the bridge 'a' has a 'when' that does not look at what it carries; name the port",
      "a: nonsense | 6:6 the bridge 'a' must be a section of names and values"})
  void mistakesNamePlaceAndRemedy(String bridge, String told) {
    String only = only(bridge);
    assertTrue(only.startsWith(told), only);
  }

  @Test
  void aLoopIsRefusedByNameAndTheOtherBridgesStay() {
    String loop = """
        one: {from: Natalie.x, to: Keira.ros.x}
        two: {from: Keira.ros.x, to: Keira.arm.x}
        three: {from: Keira.arm.x, to: Natalie.x}
        """;
    assertEquals("8:3 the bridge 'three' closes a loop: Keira.arm.x -> Natalie.ros.x -> Keira.ros.x -> Keira.arm.x"
        + " (by 'three', 'one', 'two'); leave one of them out, or 'both'", only(loop));
    assertEquals(List.of("one", "two"), read(loop).bridges().stream().map(BridgeConfig::name).toList());
  }

  @Test
  void bothWaysIsNoLoopByItselfButTwiceIs() {
    assertEquals(List.of(), read("one: {from: Natalie.x, to: Keira.ros.x, both: true}").problems());
    assertEquals("7:3 the bridge 'two' carries Keira.ros.x to Natalie.ros.x, as 'one' does; leave one of them out",
        only("one: {from: Natalie.x, to: Keira.ros.x, both: true}\ntwo: {from: Keira.ros.x, to: Natalie.x}"));
  }

  @Test
  void aServiceMayTakeNothingOfItsRequest() {
    ConfigResult result = read("gripper: {kind: service, from: Natalie.open, to: 'Keira.ros.gripper:0/open',"
        + " type: std_srvs/Trigger, fields: {}, reply: {success: 1, message: \"'told'\"}}");
    assertEquals(List.of(), result.problems());
    assertTrue(result.bridges().getFirst().settings().has("fields"));
  }

  @Test
  void aServiceAndATopicOfOneNameAreNoLoop() {
    String topic = "one: {from: Natalie.x, to: Keira.ros.x}\n";
    assertEquals(List.of(), read(topic + "two: {from: Keira.ros.x, to: Natalie.x, kind: service}").problems());
    assertTrue(only(topic + "two: {from: Keira.ros.x, to: Natalie.x, kind: service}\n"
        + "three: {from: Natalie.x, to: Keira.ros.x, kind: service}").contains("closes a loop"));
  }

  @Test
  void aFileWithoutBridgesHasNone() {
    assertEquals(List.of(), read("").bridges());
    assertEquals(List.of(), read("").problems());
  }
}
