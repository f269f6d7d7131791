package org.robotui.ros.msgs.actionlib_msgs;

import java.util.List;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * States of an action server's goals ({@code actionlib_msgs/GoalStatusArray}).
 *
 * @param header time
 * @param statusList the states
 */
@MessageType("actionlib_msgs/GoalStatusArray")
public record GoalStatusArray(Header header, List<GoalStatus> statusList) {

  /** Keeps immutable copies of lists. */
  public GoalStatusArray {
    statusList = List.copyOf(statusList);
  }
}
