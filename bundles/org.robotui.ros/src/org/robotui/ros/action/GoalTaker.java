package org.robotui.ros.action;

import java.util.Optional;
import org.robotui.message.DynamicMessage;

/** Works on the goals of an action that we serve. */
@FunctionalInterface
public interface GoalTaker {

  /**
   * Begins with a goal. Called on the I/O thread of the client's link; must not block. What it throws rejects the goal.
   *
   * @param goal what is asked for, without what actionlib wraps it in
   * @param client the node that asks
   * @param taken is told how far it gets, also before this returns
   * @return is called, once at most and on any thread, where somebody wants the goal to end
   */
  Runnable take(DynamicMessage goal, String client, Taken taken);

  /** A goal that is worked on. Any thread may use it. */
  interface Taken {

    /** The work on it has begun. */
    void begun();

    /**
     * Tells its client how it gets on; nothing once it has ended.
     *
     * @param feedback of the type of the action
     * @throws IllegalArgumentException if it is of another type
     */
    void feedback(DynamicMessage feedback);

    /**
     * It has ended. Only the first end counts. A goal that was begun with cannot be rejected or recalled any more: it
     * is told as aborted or preempted.
     *
     * @param end how
     * @param text for users
     * @param result of the type of the action, where there is one
     * @throws IllegalArgumentException if the result is of another type
     */
    void end(GoalEnd end, String text, Optional<DynamicMessage> result);
  }
}
