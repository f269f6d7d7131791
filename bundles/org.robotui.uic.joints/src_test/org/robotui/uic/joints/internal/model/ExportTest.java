package org.robotui.uic.joints.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointState.Joint;

class ExportTest {
  private static final SourceId ARM = new SourceId("base", "/joint_states");

  @Test
  void csvHasALinePerJointAndEmptyCellsForWhatIsUnknown() {
    assertEquals("""
        source,joint,position,velocity,effort,age_s
        base./joint_states,shoulder,1.25,,-3.0,0.5
        """, Export.csv(List.of(row("shoulder", 1.25, Double.NaN, -3))));
  }

  @Test
  void csvKeepsHostileNamesInTheirCell() {
    assertEquals("base./joint_states,\"a,\"\"b\"\"\n\",0.0,0.0,0.0,0.5\n",
        Export.csv(List.of(row("a,\"b\"\n", 0, 0, 0)))
            .substring("source,joint,position,velocity,effort,age_s\n".length()));
  }

  @Test
  void yamlIsAMapOfJointsPerSource() {
    assertEquals("""
        "base./joint_states":
          "shoulder": {position: 1.25, velocity: .nan, effort: -3.0}
          "a: \\"b\\"\\n\\x07": {position: .inf, velocity: 1.0E+12, effort: 1.0E-5}
        """, Export.yaml(
        List.of(row("shoulder", 1.25, Double.NaN, -3), row("a: \"b\"\n\u0007", Double.POSITIVE_INFINITY, 1e12, 1e-5))));
  }

  @Test
  void addressesAreThoseOfTheRobotsMessage() {
    JointRow row = row("shoulder", 0, 0, 0);
    assertEquals(Optional.of("position[3]"), Address.field(row, JointColumn.POSITION));
    assertEquals(Optional.of("position[3]"), Address.field(row, JointColumn.JOINT));
    assertEquals(Optional.of("effort[3]"), Address.field(row, JointColumn.EFFORT));
    JointRow record = new JointRow(ARM, row.joint(), JointUnit.RADIANS, Span.NONE, 0, false, JointRow.Fields.RECORDS,
        OptionalInt.of(1));
    assertEquals(Optional.of("joints[1].velocity"), Address.field(record, JointColumn.VELOCITY));
    JointRow nowhere = new JointRow(ARM, row.joint(), JointUnit.RADIANS, Span.NONE, 0, false, JointRow.Fields.ARRAYS,
        OptionalInt.empty());
    assertEquals(Optional.empty(), Address.field(nowhere, JointColumn.POSITION));
  }

  private static JointRow row(String name, double position, double velocity, double effort) {
    return new JointRow(ARM, new Joint(name, position, velocity, effort), JointUnit.RADIANS, Span.NONE, 0.5, false,
        JointRow.Fields.ARRAYS, OptionalInt.of(3));
  }
}
