package org.robotui.rfic.player.internal.convert;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.player.interfaces.Actarray;
import org.robotui.player.interfaces.Angles;
import org.robotui.player.interfaces.Point3d;

class JointsTest {
  private static final Actarray.State STATE = new Actarray.State(
      List.of(new Actarray.Actuator(0.5f, 0.25f, 0, 3, 2), new Actarray.Actuator(-1, 0, 0, 0, 1)), true);

  @Test
  void jointsAreNamedAfterTheirDevice() {
    JointState.Joint joint = Joints.state(STATE, "actarray:1").joints().getFirst();
    assertEquals("actarray_1_0", joint.name());
    assertEquals(0.5, joint.position());
    assertEquals(0.25, joint.velocity());
    assertTrue(Double.isNaN(joint.effort()), "a current is no effort");
    assertEquals(1, Joints.index(JointCommand.position("actarray_1_1", 0), "actarray:1", 2));
    assertThrows(IllegalArgumentException.class,
        () -> Joints.index(JointCommand.position("actarray_1_2", 0), "actarray:1", 2));
  }

  @Test
  void theModelHasTheBounds() {
    Actarray.Link slide =
        new Actarray.Link(1, 0.1f, new Angles(0, 0, 0), new Point3d(0, 0, 1), 2, 0, -2, 0, 0.5f, false);
    JointModel.Joint joint =
        Joints.model(new Actarray.Geometry(List.of(slide), new Point3d(0, 0, 0), new Angles(0, 0, 0)), "actarray:0")
            .joints().getFirst();
    assertEquals(JointModel.Type.PRISMATIC, joint.type());
    assertEquals(-2, joint.lower());
    assertEquals(2, joint.upper());
    assertEquals(0.5, joint.velocity());
  }

  @Test
  void whatWeSentIsTheReference() {
    List<JointControl.Joint> joints = Joints.control(STATE, "actarray:0", Map.of(1, 0.75)).joints();
    assertEquals(JointControl.Source.HOLDING, joints.get(0).source());
    assertEquals(0.5, joints.get(0).reference().position());
    assertEquals(JointControl.Source.COMMANDED, joints.get(1).source());
    assertEquals(0.75, joints.get(1).reference().position());
    assertEquals(-1, joints.get(1).measured().position());
  }
}
