package org.robotui.urdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class SrdfTest {
  private final Parsed<SemanticModel> read = Srdf.parse(Samples.SEMANTICS, UrdfTest.arm());
  private final SemanticModel arm = read.found().orElseThrow();

  @Test
  void resolvesChainsAndGroupsInGroups() {
    assertEquals(List.of("turn", "lift"), arm.group("column").orElseThrow().joints());
    assertEquals(List.of("column", "slide"), arm.group("column").orElseThrow().links());
    assertEquals(List.of("turn", "lift", "grip"), arm.group("all").orElseThrow().joints());
    assertEquals(List.of("column", "slide", "finger"), arm.group("all").orElseThrow().links());
  }

  @Test
  void readsStatesAndPairs() {
    assertEquals(List.of(new SemanticModel.GroupState("up", "column", Map.of("lift", 0.4))), arm.states());
    assertEquals(List.of(new SemanticModel.LinkPair("base", "column", "Adjacent")), arm.disabledCollisions());
  }

  @Test
  void warnsOfWhatTheRobotLacks() {
    assertEquals(List.of(new Problem(6, "the robot has no joint 'none'")),
        assertInstanceOf(Parsed.Ok.class, read).warnings());
  }

  @Test
  void refusesGroupsThatContainEachOther() {
    String text =
        "<robot name='arm'><group name='a'><group name='b'/></group><group name='b'><group name='a'/></group></robot>";
    Parsed.Refused<?> refused = assertInstanceOf(Parsed.Refused.class, Srdf.parse(text, UrdfTest.arm()));
    assertTrue(refused.problem().message().contains("contains itself"), refused.problem().toString());
  }
}
