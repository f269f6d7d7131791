package org.robotui.uic.joints.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Comparator;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointState.Joint;

class JointColumnTest {
  @Test
  void anglesAreInRadiansOrDegreesAndLengthsAlwaysInMetres() {
    assertEquals("\u22121.571\u00a0rad", JointColumn.POSITION.text(row(JointUnit.RADIANS, -Math.PI / 2), false));
    assertEquals("\u221290.0\u00b0", JointColumn.POSITION.text(row(JointUnit.RADIANS, -Math.PI / 2), true));
    assertEquals("0.1234\u00a0m", JointColumn.POSITION.text(row(JointUnit.METRES, 0.1234), true));
  }

  @Test
  void aJointOfUnknownKindHasNoUnitAndTheHeadingSaysWhatItMayBe() {
    assertEquals("0.500", JointColumn.POSITION.text(row(JointUnit.UNKNOWN, 0.5), false));
    assertEquals("Position, rad or m", JointColumn.POSITION.heading(false, true));
    assertEquals("Position, \u00b0 if rotary", JointColumn.POSITION.heading(true, true));
    assertEquals("Position", JointColumn.POSITION.heading(true, false));
  }

  @Test
  void whatIsUnknownIsADashAndNeverNaN() {
    JointRow row = row(JointUnit.METRES, Double.NaN);
    for (JointColumn column : List.of(JointColumn.POSITION, JointColumn.VELOCITY, JointColumn.EFFORT,
        JointColumn.RANGE)) {
      assertEquals("\u2014", column.text(row, true), column.name());
      assertEquals("\u2014", column.text(row, false), column.name());
    }
  }

  @Test
  void unknownValuesSortBelowAllOthers() {
    List<JointRow> sorted =
        Stream.of(row(JointUnit.RADIANS, 1), row(JointUnit.RADIANS, Double.NaN), row(JointUnit.RADIANS, -5))
            .sorted(JointColumn.POSITION.order()).toList();
    assertTrue(Double.isNaN(sorted.getFirst().joint().position()));
    Comparator<JointRow> down = JointColumn.POSITION.order().reversed();
    assertEquals(1, sorted.stream().sorted(down).findFirst().orElseThrow().joint().position());
  }

  @Test
  void aSpanGrowsWithWhatIsSeenAndConfiguredLimitsStay() {
    Span seen = Span.NONE.with(1).with(Double.NaN).with(-1).with(Double.POSITIVE_INFINITY);
    assertEquals(new Span(-1, 1, false), seen);
    assertEquals(0.75, seen.share(0.5));
    assertTrue(Double.isNaN(Span.NONE.share(0)));
    assertTrue(Double.isNaN(seen.share(Double.NaN)));
    assertEquals(0.5, Span.NONE.with(3).share(3), "one value alone lies in the middle");
    Span limits = new Span(0, 1, true);
    assertEquals(limits, limits.with(7));
    assertEquals(1, limits.share(7));
    assertTrue(limits.isBeyond(7));
    assertFalse(seen.isBeyond(7));
    assertFalse(limits.isBeyond(Double.NaN));
  }

  private static JointRow row(JointUnit unit, double position) {
    return new JointRow(new SourceId("base", "/joint_states"), new Joint("arm", position, Double.NaN, Double.NaN), unit,
        Span.NONE.with(position), 0, false, JointRow.Fields.ARRAYS, OptionalInt.empty());
  }
}
