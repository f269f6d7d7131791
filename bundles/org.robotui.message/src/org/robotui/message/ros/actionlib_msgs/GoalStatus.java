package org.robotui.message.ros.actionlib_msgs;

import org.robotui.message.MessageType;

/**
 * State of one goal of an action ({@code actionlib_msgs/GoalStatus}).
 *
 * @param goalId the goal
 * @param status one of the constants, such as {@link #ACTIVE}
 * @param text the state in words
 */
@MessageType("actionlib_msgs/GoalStatus")
public record GoalStatus(GoalID goalId, int status, String text) {

  /** The constant {@code PENDING} of the definition. */
  public static final int PENDING = 0;
  /** The constant {@code ACTIVE} of the definition. */
  public static final int ACTIVE = 1;
  /** The constant {@code PREEMPTED} of the definition. */
  public static final int PREEMPTED = 2;
  /** The constant {@code SUCCEEDED} of the definition. */
  public static final int SUCCEEDED = 3;
  /** The constant {@code ABORTED} of the definition. */
  public static final int ABORTED = 4;
  /** The constant {@code REJECTED} of the definition. */
  public static final int REJECTED = 5;
  /** The constant {@code PREEMPTING} of the definition. */
  public static final int PREEMPTING = 6;
  /** The constant {@code RECALLING} of the definition. */
  public static final int RECALLING = 7;
  /** The constant {@code RECALLED} of the definition. */
  public static final int RECALLED = 8;
  /** The constant {@code LOST} of the definition. */
  public static final int LOST = 9;
}
