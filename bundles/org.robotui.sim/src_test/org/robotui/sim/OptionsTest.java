package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.model.Robots;
import org.robotui.sim.internal.ros.RosOptions;
import org.robotui.sim.internal.ros2.DomainOptions;

class OptionsTest {
  @Test
  void withoutArgumentsAFreePortAndNoNamespaceAreUsed() {
    Options options = Options.parse(List.of());
    assertEquals(Robots.NATALIE, options.robot());
    assertEquals(Set.of(Options.Speech.ROS), options.speaks());
    assertEquals(0, options.ros().port());
    assertEquals("", options.ros().namespace());
    assertEquals(OptionalLong.empty(), options.parent());
    assertEquals(1, options.speedFactor());
  }

  @Test
  void everyOptionIsRead() {
    Options options = Options.parse(List.of(
        "--port", "11311", "--namespace", "/keira/", "--name", "base", "--seed", "-7", "--speed-factor", "2.5",
        "--real-master", "http://localhost:11311", "--sim-time", "--parent", "4711", "--swarm", "12",
        "plan:=/move_base/plan", "--yarp-port", "10009", "--smartsoft-port", "20003", "--roblets-port", "7853",
        "--roboframe-port", "7421", "--boat", "--humanoid", "--urdf", "humanoid.urdf",
        "--robot", "Keira", "--speak", "player,lcm", "--player-port", "6665", "--carmen-port", "1382", "--lcm-url",
        "udpm://239.1.1.1:7000",
        "--lcm-types", "types", "--domain", "42", "--subnet"));
    RosOptions ros = new RosOptions(
        11311, "keira", "base", Optional.of(URI.create("http://localhost:11311")), true,
        List.of("plan:=/move_base/plan"));
    assertEquals(
        new Options(
            Robots.KEIRA, Set.of(Options.Speech.PLAYER, Options.Speech.LCM), ros,
            new DomainOptions(OptionalInt.of(42), true), 6665, 1382, 10009, 20_003, 7853, 7421,
            Optional.of(URI.create("udpm://239.1.1.1:7000")),
            Optional.of(Path.of("types")), -7, 2.5, OptionalLong.of(4711), 12, true,
            Optional.of(Path.of("humanoid.urdf"))),
        options);
  }

  @Test
  void mistakesAreNamed() {
    assertMistake("--port", "--port");
    assertMistake("0 to 65535", "--port", "70000");
    assertMistake("0 to 232", "--domain", "233");
    assertMistake("'fast'", "--speed-factor", "fast");
    assertMistake("0.01 to 50", "--speed-factor", "0");
    assertMistake("http", "--real-master", "localhost:11311");
    assertMistake("natalie, keira", "--robot", "otto");
    assertMistake("'corba'", "--speak", "ros,corba");
    assertMistake("--lcm-types", "--speak", "lcm");
    assertMistake("--urdf", "--humanoid");
    assertMistake("'--colour'", "--colour", "red");
    assertMistake("'stray'", "stray");
  }

  private static void assertMistake(String named, String... arguments) {
    String message =
        assertThrows(IllegalArgumentException.class, () -> Options.parse(List.of(arguments))).getMessage();
    assertTrue(message.contains(named), message);
  }
}
