package org.robotui.message.ros.actionlib_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

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
