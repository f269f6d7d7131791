package org.robotui.data.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.data.command.MotionLimits;

class JointCommandTest {
  private static JointCommand velocity(double value) {
    return new JointCommand(List.of(new JointCommand.Joint("elbow",
        new JointControl.Reference(0, value, 0, 0, 0), Set.of(JointMode.VELOCITY))));
  }

  @Test
  void itsStopLetsAllJointsGo() {
    assertEquals(JointCommand.ZERO, velocity(1).stopped());
  }

  @Test
  void velocitiesAreCutToTheLimits() {
    assertEquals(velocity(-0.5), velocity(-2).within(new MotionLimits(0.2, 0.5)));
    assertEquals(velocity(0.4), velocity(0.4).within(new MotionLimits(0.2, 0.5)));
  }

  @Test
  void whatIsNoNumberIsNoCommand() {
    IllegalArgumentException refused = assertThrows(IllegalArgumentException.class, () -> velocity(Double.NaN));
    assertEquals("elbow velocity: must be finite, is NaN", refused.getMessage());
  }

  @Test
  void modesAreThoseOfTheirBits() {
    assertEquals(Set.of(JointMode.STIFFNESS, JointMode.DAMPING), JointMode.ofBits(24));
    assertEquals(Set.of(), JointMode.ofBits(0));
  }
}
