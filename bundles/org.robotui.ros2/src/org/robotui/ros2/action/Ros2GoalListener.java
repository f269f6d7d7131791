package org.robotui.ros2.action;

import org.robotui.message.DynamicMessage;

/**
 * Hears of one goal. Called on the receiving thread of the context, on that which sends the goal and on the client's
 * own, one call at a time; must not block. What it throws is logged.
 */
public interface Ros2GoalListener {

  /**
   * The goal got further.
   *
   * @param phase where it is now; {@link Ros2GoalPhase#DONE} comes last
   */
  default void onPhase(Ros2GoalPhase phase) {}

  /**
   * The server tells how it gets on. Never called after the goal ended.
   *
   * @param feedback without the identifier
   */
  default void onFeedback(DynamicMessage feedback) {}

  /**
   * The goal ended. Called once, after the last phase.
   *
   * @param outcome how
   */
  default void onDone(Ros2GoalOutcome outcome) {}
}
