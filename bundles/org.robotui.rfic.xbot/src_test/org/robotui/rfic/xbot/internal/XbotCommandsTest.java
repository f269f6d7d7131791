package org.robotui.rfic.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.xbot.JointReference;
import org.robotui.xbot.StateFrame;

class XbotCommandsTest {
  @Test
  void jointsAreToldByTheirPlaceOnTheBoard() throws IOException {
    JointCommand command = new JointCommand(List.of(new JointCommand.Joint("lift",
        new JointControl.Reference(0.2, 0, 0, 50, 2), Set.of(JointMode.POSITION, JointMode.STIFFNESS))));
    assertEquals(List.of(new JointReference(1, new StateFrame.Reference(0.2, 0, 0, 50, 2), 9)),
        XbotCommands.references(command, List.of("pan", "lift")));
  }

  @Test
  void aJointThatTheRobotLacksIsNamed() {
    JointCommand command = new JointCommand(List.of(JointCommand.position("elbow", 1)));
    assertEquals("there is no joint elbow",
        assertThrows(IOException.class, () -> XbotCommands.references(command, List.of("pan"))).getMessage());
  }
}
