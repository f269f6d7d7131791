package org.robotui.rfic.lcm.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;

/** What is wrong with a configuration is said with its place, what was expected, and what to write. */
class FaultsTest {
  private static final String TYPES = Written.types().toString();

  private static List<SettingFault> faults(Map<String, ?> channels, Map<String, ?> commands) {
    return faults(Written.settings("tcpq://127.0.0.1:7700", TYPES, channels, commands));
  }

  private static List<SettingFault> faults(Settings settings) {
    return new LcmRficType().faults(settings);
  }

  private static void assertFault(String start, String part, List<SettingFault> faults) {
    assertEquals(1, faults.size(), faults.toString());
    String text = faults.getFirst().toString();
    assertTrue(text.startsWith(start) && text.contains(part), text);
  }

  @Test
  void aGuardIsForServersAlone() {
    Settings server = Written.settings("tcpq://127.0.0.1:7700", TYPES, Map.of(), Map.of());
    Settings group = Written.settings("udpm://239.255.76.67:7667?ttl=0", TYPES, Map.of(), Map.of());
    assertEquals(List.of(), faults(Written.guarded(server, true)));
    assertEquals(List.of(), faults(Written.guarded(group, false)));
    assertFault("robot.yaml:4:9", "for servers (tcpq://HOST:PORT) alone", faults(Written.guarded(group, true)));
  }

  @Test
  void whatIsRightHasNoFaults() {
    assertEquals(List.of(), faults(
        Map.of("ODOMETRY", Written.map("as", "odometry", "type", "robotui.odometry_t"), "LASER", "laserscan"),
        Map.of("VELOCITY", Written.map("as", "velocity", "type", "robotui.velocity_t"),
            "GOAL",
            Written.map("as", "goal", "type", "robotui.goal_t", "position", "pose.position", "orientation",
                "pose.orientation",
                "set", Map.of("id", "ui")))));
  }

  @Test
  void wordsThatMeanNothingAreRefused() {
    assertFault("robot.yaml:10:10: ", "write one of battery, gps, gridmap",
        faults(Map.of("X", Written.map("as", "odometri")), Map.of()));
    assertFault("robot.yaml:10:5: ", "'as' is missing", faults(Map.of("X", Written.map("x", "pos[0]")), Map.of()));
    assertFault("robot.yaml:10:11: ", "'odometry' has no field 'xx'; it has position, x",
        faults(Map.of("X", Written.map("as", "odometry", "xx", "a")), Map.of()));
    assertFault("robot.yaml:10:11: ", "'furlong' is no unit here; write one of m, cm, mm",
        faults(Map.of("X", Written.map("as", "odometry", "x", "a furlong")), Map.of()));
    assertFault("robot.yaml:10:11: ", "names no member",
        faults(Map.of("X", Written.map("as", "odometry", "x", "a[b]")), Map.of()));
  }

  @Test
  void membersAreLookedUpInTheType() {
    Map<String, Object> mapping =
        Written.map("as", "odometry", "type", "robotui.odometry_t", "x", "pos[0]", "y", "position[1]");
    assertFault("robot.yaml:10:12: ", "robotui.odometry_t has no member 'pos'; it has [utime, frame",
        faults(Map.of("X", mapping), Map.of()));
    assertFault("robot.yaml:10:12: ", "is declared as 'double position[3]'; add an index such as [0]",
        faults(Map.of("X", Written.map("as", "battery", "type", "robotui.odometry_t", "voltage", "position")),
            Map.of()));
    assertFault("robot.yaml:10:5: ", "X as gridmap needs 'cells'",
        faults(Map.of("X", Written.map("as", "gridmap", "type", "robotui.pose_t")), Map.of()));
    assertFault("robot.yaml:10:11: ", "no .lcm file declares the type 'robotui.pos_t'; there are",
        faults(Map.of("X", Written.map("as", "pose", "type", "robotui.pos_t")), Map.of()));
  }

  @Test
  void commandsNeedATypeThatCanHoldThem() {
    assertFault("robot.yaml:100:5: ", "'type' is missing",
        faults(Map.of(), Map.of("V", Written.map("as", "velocity"))));
    assertFault("robot.yaml:100:5: ", "needs 'linear', or 'vx'",
        faults(Map.of(), Map.of("V", Written.map("as", "velocity", "type", "robotui.pose_t"))));
    assertFault("robot.yaml:100:5: ", "takes one number", faults(Map.of(), Map.of("V",
        Written.map("as", "velocity", "type", "robotui.battery_t", "linear", "voltage", "wz", "current"))));
    assertFault("robot.yaml:100:12: ", "robotui.velocity_t has no member 'mode'", faults(Map.of(), Map.of("V",
        Written.map("as", "velocity", "type", "robotui.velocity_t", "set", Map.of("mode", "1")))));
  }

  @Test
  void theUrlAndTheFoldersAreChecked() {
    assertFault("robot.yaml:2:7: ", "no LCM URL", faults(Written.settings("localhost", TYPES, Map.of(), Map.of())));
    assertFault("robot.yaml:2:7: ", "no multicast address",
        faults(Written.settings("udpm://10.0.0.1:1", TYPES, Map.of(), Map.of())));
    assertFault("robot.yaml:3:9: ", "there is no file or folder",
        faults(Written.settings("memq://", "/nowhere", Map.of(), Map.of())));
  }

  @Test
  void twoThingsOfOneChannelHaveTwoPorts() {
    LcmSettings settings = Written.right(Written.settings("memq://", TYPES,
        Map.of("POSE", List.of("odometry", Written.map("as", "pose"), Written.map("as", "imu", "port", "imu"))),
        Map.of()));
    assertEquals(List.of("POSE", "POSE/pose", "imu"),
        settings.streams().stream().map(LcmSettings.Stream::port).toList());
    assertFault("robot.yaml:10:11: ", "is there already", faults(
        Map.of("POSE", List.of("odometry", Written.map("as", "pose", "port", "POSE"))), Map.of()));
  }
}
