package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.ros2.Ros2Environment.Range;
import org.robotui.rtps.Interfaces;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.InitialPeer;

class Ros2EnvironmentTest {

  private static Ros2Environment of(String... pairs) {
    Map<String, String> variables = new HashMap<>();
    for (int i = 0; i < pairs.length; i += 2) {
      variables.put(pairs[i], pairs[i + 1]);
    }
    return Ros2Environment.of(variables, List.of());
  }

  private static List<String> hosts(ParticipantSettings settings) {
    return settings.peers().stream().map(InitialPeer::host).toList();
  }

  @Test
  void nothingIsReachedBeyondThisMachineUnlessSomebodySaysSo() {
    ParticipantSettings settings = of().participant(Optional.empty());
    assertEquals(new Interfaces.Loopback(), settings.interfaces());
    assertEquals(List.of("127.0.0.1"), hosts(settings));
    assertEquals("enclave=/;", StandardCharsets.UTF_8.decode(settings.userData()).toString());
    assertEquals(0, settings.domain());
  }

  @Test
  void theSubnetIsReachedWhereItIsSaid() {
    Ros2Environment environment = of("ROS_DOMAIN_ID", " 7 ", "ROS_AUTOMATIC_DISCOVERY_RANGE", "subnet");
    ParticipantSettings settings = environment.participant(Optional.of("name"));
    assertEquals(new Interfaces.All(), settings.interfaces());
    assertTrue(settings.multicast());
    assertEquals(7, settings.domain());
    assertEquals(new Interfaces.Named(List.of("eth0")),
        environment.within(Range.SUBNET, List.of(), List.of("eth0")).participant(Optional.empty()).interfaces());
    assertEquals(Range.LOCALHOST,
        of("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET", "ROS_LOCALHOST_ONLY", "1").range());
  }

  @Test
  void machinesThatAreNamedAreAskedOneByOne() {
    ParticipantSettings settings = of("ROS_STATIC_PEERS", "10.0.0.5; robot.local;").participant(Optional.empty());
    assertEquals(List.of("127.0.0.1", "10.0.0.5", "robot.local"), hosts(settings));
    assertEquals(new Interfaces.All(), settings.interfaces());
    assertFalse(settings.multicast(), "nobody else is looked for");
    ParticipantSettings off = of("ROS_STATIC_PEERS", "10.0.0.5", "ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
        .participant(Optional.empty());
    assertEquals(List.of(), hosts(off));
    assertFalse(off.multicast());
  }

  @Test
  void whatIsWrongIsNamed() {
    assertEquals("ROS_DOMAIN_ID: 'x' is no number; write 0 to 232",
        assertThrows(IllegalArgumentException.class, () -> of("ROS_DOMAIN_ID", "x")).getMessage());
    assertEquals("ROS_DOMAIN_ID: 233 is no domain; write 0 to 232",
        assertThrows(IllegalArgumentException.class, () -> of("ROS_DOMAIN_ID", "233")).getMessage());
    assertEquals("ROS_AUTOMATIC_DISCOVERY_RANGE: 'FAR' is no range; write LOCALHOST, SUBNET or OFF",
        assertThrows(IllegalArgumentException.class, () -> of("ROS_AUTOMATIC_DISCOVERY_RANGE", "far")).getMessage());
  }

  @Test
  void argumentsRename() {
    Ros2Environment environment = Ros2Environment.of(Map.of(),
        List.of("first", "--ros-args", "-r", "a:=b", "--remap", "__ns:=/n", "--", "last"));
    assertEquals(List.of("first", "last"), environment.arguments());
    assertEquals(2, environment.rules().size());
  }
}
