package org.robotui.rfic.xbot.internal.follow;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.ActionReply;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

/** The error codes of control_msgs/FollowJointTrajectory. */
enum FollowCode {
  SUCCESSFUL(0), INVALID_GOAL(-1), INVALID_JOINTS(-2), OLD_HEADER_TIMESTAMP(-3), PATH_TOLERANCE_VIOLATED(-4),
  GOAL_TOLERANCE_VIOLATED(-5);

  private static final String RESULT = "control_msgs/FollowJointTrajectoryResult";

  private final int number;

  FollowCode(int number) {
    this.number = number;
  }

  /** How a goal ended, with its result. */
  ActionReply end(ActionReply.End end, String text) {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("error_code", new FieldValue.Num(number, Integer.toString(number)));
    fields.put("error_string", new FieldValue.Text(text));
    return new ActionReply(end, text, Optional.of(new MapRecord(RESULT, fields)));
  }

  /** A goal that is refused. */
  ActionReply rejected(String text) {
    return end(ActionReply.End.REJECTED, text);
  }
}
