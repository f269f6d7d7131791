package org.robotui.ros2.name;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.message.description.TypeName;

class NamesTest {

  @Test
  void wholeNamesAreChecked() {
    for (String good : List.of("/", "/a", "/a/b_2", "/_hidden/x", "/a__b")) {
      assertEquals(good, Ros2Name.of(good).text());
    }
    for (String bad : List.of("", "a", "//a", "/a/", "/2a", "/a/2", "/a b", "/a-b", "/ü", "/a/~b",
        "/" + "a".repeat(247))) {
      assertEquals(Optional.empty(), Ros2Name.parse(bad), bad);
    }
    assertEquals(
        "'/2a' is no name of ROS 2: its part '2a' must hold letters, digits and '_' and not start with a digit",
        assertThrows(IllegalArgumentException.class, () -> Ros2Name.of("/2a")).getMessage());
  }

  @Test
  void namesHaveNamespaces() {
    assertEquals(Ros2Name.of("/a"), Ros2Name.of("/a/b").namespace());
    assertEquals(Ros2Name.ROOT, Ros2Name.of("/a").namespace());
    assertEquals("/a", Ros2Name.ROOT.join("a").text());
    assertTrue(Ros2Name.of("/a").contains(Ros2Name.of("/a/b")) && Ros2Name.ROOT.contains(Ros2Name.of("/a")));
    assertFalse(Ros2Name.of("/a").contains(Ros2Name.of("/ab")));
    assertTrue(Ros2Name.of("/a/_action/status").hidden() && !Ros2Name.of("/a_b").hidden());
  }

  @Test
  void namesAreResolvedAsSeenFromANode() {
    Ros2NameResolver names = Ros2NameResolver.of(Ros2Name.of("/robot"), "base", List.of());
    assertEquals("/robot/base", names.node().text());
    assertEquals("/robot/scan", names.topic("scan").text());
    assertEquals("/scan", names.topic("/scan").text());
    assertEquals("/robot/base/state", names.topic("~/state").text());
    assertEquals("/robot/base", names.topic("~").text());
    assertEquals("/robot/base_x", names.topic("{ns}/{node}_x").text());
    assertThrows(IllegalArgumentException.class, () -> names.topic("a b"));
  }

  @Test
  void rulesRenameNodesTopicsAndServices() {
    List<RemapRule> rules = List.of("__ns:=/r2", "__node:=arm", "scan:=/front/scan", "other:x:=y",
        "rosservice://stop:=halt", "rostopic://~/t:=/t").stream().map(RemapRule::parse).toList();
    Ros2NameResolver names = Ros2NameResolver.of(Ros2Name.ROOT, "base", rules);
    assertEquals("/r2/arm", names.node().text());
    assertEquals("/front/scan", names.topic("scan").text());
    assertEquals("/front/scan", names.topic("/r2/scan").text());
    assertEquals("/r2/x", names.topic("x").text(), "the rule is for another node");
    assertEquals("/r2/stop", names.topic("stop").text());
    assertEquals("/r2/halt", names.service("stop").text());
    assertEquals("/t", names.topic("~/t").text());
    assertThrows(IllegalArgumentException.class, () -> RemapRule.parse("scan"));
  }

  @Test
  void namesOfDdsAreMangledAndBack() {
    for (String each : List.of("rt/chatter", "rq/arm/set_boolRequest", "rr/arm/set_boolReply",
        "rt/count/_action/feedback")) {
      assertEquals(each, DdsName.parse(each).orElseThrow().text());
    }
    assertEquals(new DdsName(DdsName.Role.REQUEST, Ros2Name.of("/arm/set_bool")),
        DdsName.parse("rq/arm/set_boolRequest").orElseThrow());
    for (String other : List.of("chatter", "ros_discovery_info", "rq/arm/set_bool", "rt/", "rt//a",
        "DCPSParticipant")) {
      assertEquals(Optional.empty(), DdsName.parse(other), other);
    }
  }

  @Test
  void typesOfDdsAreMangledAndBack() {
    TypeName type = TypeName.parse("std_srvs/srv/SetBool_Request").orElseThrow();
    assertEquals("std_srvs::srv::dds_::SetBool_Request_", DdsName.ofType(type));
    assertEquals(Optional.of(type), DdsName.type("std_srvs::srv::dds_::SetBool_Request_"));
    for (String other : List.of("std_msgs::String", "std_msgs::msg::dds_::String", "a::b::dds_::C_", "")) {
      assertEquals(Optional.empty(), DdsName.type(other), other);
    }
  }
}
