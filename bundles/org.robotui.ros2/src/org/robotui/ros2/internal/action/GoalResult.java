package org.robotui.ros2.internal.action;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.message.CdrReader;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;

/**
 * What a server answers when a goal has ended. Its number comes first, so that it is read also where the result is of
 * another version, as results of navigation differ between distributions.
 *
 * @param status the number, 0 where there is none
 * @param fault why the result cannot be read, else empty
 * @param result the result
 */
record GoalResult(int status, String fault, Optional<DynamicMessage> result) {

  static GoalResult read(ByteBuffer bytes, MessageSchema schema) {
    int status = 0;
    try {
      status = new CdrReader(bytes).int8("status");
      DynamicMessage whole = DynamicMessage.read(schema, new CdrReader(bytes));
      return new GoalResult(status, "", GoalIds.inner(whole, "result"));
    } catch (MessageException e) {
      return new GoalResult(status, "its result cannot be read: " + e.getMessage(), Optional.empty());
    }
  }
}
