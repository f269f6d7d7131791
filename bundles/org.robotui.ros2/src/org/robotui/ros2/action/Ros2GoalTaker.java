package org.robotui.ros2.action;

import java.util.Optional;
import org.robotui.message.DynamicMessage;

/** Works on the goals of an action that we offer, on threads of its own. */
@FunctionalInterface
public interface Ros2GoalTaker {

  /**
   * Begins with a goal. Called on the thread of a service; must not block. What it throws rejects the goal.
   *
   * @param goal what is asked for
   * @param taken is told how far it gets, also before this returns
   * @return is called, once at most and on any thread, where somebody wants the goal to end
   */
  Runnable take(DynamicMessage goal, Taken taken);

  /** A goal of a client, who waits until it is accepted or rejected. Any thread may use it. */
  interface Taken {

    /** It is accepted, and the work on it has begun. */
    void accept();

    /**
     * Tells how it gets on, which accepts it; nothing once it has ended.
     *
     * @param feedback of the type of the action
     * @throws IllegalArgumentException if it is of another type
     */
    void feedback(DynamicMessage feedback);

    /**
     * It has ended. Only the first end counts. A goal that was accepted cannot be rejected any more: it is told as
     * aborted.
     *
     * @param end how
     * @param result of the type of the action, where there is one
     * @throws IllegalArgumentException if the result is of another type
     */
    void end(Ros2GoalEnd end, Optional<DynamicMessage> result);
  }
}
