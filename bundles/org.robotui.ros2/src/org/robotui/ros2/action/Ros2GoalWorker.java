package org.robotui.ros2.action;

import java.util.Map;
import org.robotui.message.DynamicMessage;

/** Works on the goals of an action that we offer. */
public interface Ros2GoalWorker {

  /**
   * Whether a goal is taken. Called on the thread of a service; must be quick.
   *
   * @param goal what is asked for
   * @return false to reject it
   */
  default boolean accept(DynamicMessage goal) {
    return true;
  }

  /**
   * Works on a goal. Called on a thread of its own; ends with the goal. An exception aborts the goal.
   *
   * @param goal what is asked for
   * @param running says whether it is cancelled, and tells how it gets on
   * @return how it ended
   * @throws InterruptedException if the thread is interrupted; the goal is aborted
   */
  End work(DynamicMessage goal, Running running) throws InterruptedException;

  /** A goal that is worked on. */
  interface Running {

    /**
     * Whether somebody wants it to end.
     *
     * @return true from then on
     */
    boolean cancelled();

    /**
     * Tells how it gets on.
     *
     * @param values of the feedback by field name
     * @throws IllegalArgumentException if they do not fit to the type
     */
    void feedback(Map<String, ?> values);
  }

  /**
   * How a goal ended.
   *
   * @param end succeeded, aborted or cancelled
   * @param result values of the result by field name
   */
  record End(Ros2GoalEnd end, Map<String, ?> result) {

    /** Copies the values and checks the end. */
    public End {
      result = Map.copyOf(result);
      if (end == Ros2GoalEnd.REJECTED || end == Ros2GoalEnd.LOST) {
        throw new IllegalArgumentException("a goal that is worked on does not end " + end);
      }
    }
  }
}
