package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class GraphNameTest {

  @ParameterizedTest
  @CsvSource({"/a/b,/a/b", "a//b/,a/b", "~a,~a", "~/a,~a", "/,/", "~,~"})
  void namesAreCleaned(String text, String clean) {
    assertEquals(clean, GraphName.of(text).text());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "1a", "_a", "a b", "a-b", "a~", "ä", "a:b", " a", "/a b", "/a~b", "/\u00e4", "/a\n",
      "~a-b"})
  void otherTextsAreRefusedWithTheReason(String text) {
    String message = assertThrows(InvalidNameException.class, () -> GraphName.of(text)).getMessage();
    assertTrue(message.contains("'" + text + "'"), message);
  }

  @ParameterizedTest
  @ValueSource(strings = {"/front-left/scan", "/1a", "/camera.rgb/image", "/a:b", "/_a"})
  void globalNamesAreTakenAsMastersHandThemOut(String text) {
    assertEquals(text, NameResolver.of(GraphName.of("/n"), GraphName.ROOT, Map.of()).resolve(text).text());
  }

  @ParameterizedTest
  @CsvSource({"/scan,/scan", "scan,/robot/scan", "~scan,/robot/base/scan", "in,/out", "/robot/in,/out",
      "~,/robot/base"})
  void namesResolveInTheirNamespaceAndAreRemapped(String name, String global) {
    NameResolver names = NameResolver.of(GraphName.of("/robot/base"), GraphName.of("/robot"), Map.of("in", "/out"));
    assertEquals(global, names.resolve(name).text());
  }

  @Test
  void namespacesAreFound() {
    assertEquals(GraphName.of("/a"), GraphName.of("/a/b").namespace());
    assertEquals(GraphName.ROOT, GraphName.of("/a").namespace());
    assertTrue(GraphName.ROOT.contains(GraphName.of("/a")));
    assertTrue(GraphName.of("/a").contains(GraphName.of("/a/b")));
    assertEquals(false, GraphName.of("/a").contains(GraphName.of("/ab")));
  }

  @Test
  void anonymousNamesDiffer() {
    assertNotEquals(GraphName.anonymous("n"), GraphName.anonymous("n"));
    assertTrue(GraphName.anonymous("n").text().startsWith("n_"));
  }

  @Test
  void theEnvironmentIsReadFromVariablesAndCommandLine() {
    RosEnvironment environment = RosEnvironment.of(
        Map.of("ROS_MASTER_URI", "http://robot_1:11311/", "ROS_IP", "10.0.0.1", "ROS_HOSTNAME", "me", "ROS_NAMESPACE",
            "left"),
        List.of("scan:=/laser", "__name:=base", "_rate:=10", "_frame:=odom", "_on:=true", "--verbose"));
    assertEquals(URI.create("http://robot_1:11311/"), environment.masterUri());
    assertEquals(Optional.of("me"), environment.host());
    assertEquals(GraphName.of("/left"), environment.namespace());
    assertEquals(Optional.of(GraphName.of("base")), environment.nodeName());
    assertEquals(Map.of("scan", "/laser"), environment.remappings());
    assertEquals(Map.of("rate", XmlRpcValue.of(10), "frame", XmlRpcValue.of("odom"), "on", XmlRpcValue.of(true)),
        environment.parameters());
    assertEquals(List.of("--verbose"), environment.arguments());
  }

  @Test
  void defaultsAreLoopback() {
    RosEnvironment environment = RosEnvironment.of(Map.of(), List.of());
    assertEquals(URI.create("http://localhost:11311"), environment.masterUri());
    assertEquals(Optional.empty(), environment.host());
  }

  @Test
  void aBadMasterAddressIsNamed() {
    String message = assertThrows(IllegalArgumentException.class,
        () -> RosEnvironment.of(Map.of("ROS_MASTER_URI", "robot:11311"), List.of())).getMessage();
    assertTrue(message.contains("ROS_MASTER_URI") && message.contains("robot:11311"), message);
  }
}
