package org.robotui.ros2.internal.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;
import org.robotui.message.CdrWriter;
import org.robotui.message.DefinitionException;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;

class GoalResultTest {

  private static MessageSchema response(String result) throws DefinitionException {
    return MessageSchema.parse("nav2_msgs/NavigateToPose_GetResultResponse",
        "int8 status\nnav2_msgs/R result\n=====\nMSG: nav2_msgs/R\n" + result, Generation.ROS2);
  }

  @Test
  void theEndIsKnownAlsoWhereTheResultIsOfAnotherDistribution() throws DefinitionException {
    ByteBuffer humble = new CdrWriter().u8(GoalStatuses.SUCCEEDED).u8(0).view();
    GoalResult read = GoalResult.read(humble, response("uint16 error_code\nstring error_msg\n"));
    assertEquals(GoalStatuses.SUCCEEDED, read.status());
    assertTrue(read.result().isEmpty());
    assertTrue(read.fault().startsWith("its result cannot be read: "), read.fault());
    GoalResult fitting = GoalResult.read(humble, response(""));
    assertEquals("", fitting.fault());
    assertTrue(fitting.result().isPresent());
    assertEquals(0, GoalResult.read(ByteBuffer.allocate(2), response("")).status());
  }
}
