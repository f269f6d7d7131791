package org.robotui.ros.action;

import org.robotui.message.DynamicMessage;

/**
 * Hears of one goal. Called on the I/O threads of the server's links and on the client's own, one call at a time and in
 * the order of what happened; must not block. What it throws is logged.
 */
public interface GoalListener {

  /**
   * The goal got further.
   *
   * @param phase where it is now; {@link GoalPhase#DONE} comes last
   * @param text the server's words
   */
  default void onPhase(GoalPhase phase, String text) {}

  /**
   * The server tells how it gets on. Never called after the goal ended.
   *
   * @param feedback the feedback without what actionlib wraps it in
   */
  default void onFeedback(DynamicMessage feedback) {}

  /**
   * The goal ended. Called once, after the last phase.
   *
   * @param outcome how
   */
  default void onDone(GoalOutcome outcome) {}
}
