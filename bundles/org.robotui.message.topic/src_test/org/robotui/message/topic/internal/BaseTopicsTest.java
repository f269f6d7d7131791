package org.robotui.message.topic.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;

class BaseTopicsTest {
  private static final String TWIST = "geometry_msgs/Twist";
  private static final String STAMPED = "geometry_msgs/TwistStamped";

  @Test
  void theBaseIsMovedByTheOutermostTopicOfThatName() {
    assertEquals(Set.of("/cmd_vel"),
        BaseTopics.of(Map.of("/cmd_vel", TWIST, "/head/cmd_vel", TWIST, "/arm/servo", STAMPED)).topics());
    assertEquals(Set.of("/keira/cmd_vel"),
        BaseTopics.of(Map.of("/keira/cmd_vel", TWIST, "/keira/mux/teleop", TWIST)).topics());
  }

  @Test
  void whereNothingHasThatNameAllVelocitiesMoveIt() {
    assertEquals(Set.of("/mobile_base/commands/velocity", "/mux/joystick"),
        BaseTopics.of(Map.of("/mobile_base/commands/velocity", TWIST,
            "/mux/joystick", TWIST, "/goal", "geometry_msgs/PoseStamped")).topics());
  }
}
