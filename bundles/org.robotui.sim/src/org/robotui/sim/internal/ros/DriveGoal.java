package org.robotui.sim.internal.ros;

import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;

/**
 * A goal of the navigation, as the action server tells it.
 *
 * @param id names it
 * @param status a code of {@link GoalStatus}
 * @param text for a user
 * @param since when it got this status, nanoseconds of stamps
 */
record DriveGoal(GoalID id, int status, String text, long since) {
  boolean isOver() {
    return status != GoalStatus.PENDING && status != GoalStatus.ACTIVE && status != GoalStatus.PREEMPTING;
  }

  DriveGoal with(int newStatus, String newText, long now) {
    return new DriveGoal(id, newStatus, newText, now);
  }

  GoalStatus message() {
    return new GoalStatus(id, status, text);
  }
}
