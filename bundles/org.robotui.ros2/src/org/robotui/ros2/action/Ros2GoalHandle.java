package org.robotui.ros2.action;

import java.util.concurrent.CompletionStage;

/** A goal that a server took. Any thread may use it. */
public interface Ros2GoalHandle {

  /**
   * The goal's identifier.
   *
   * @return 32 hexadecimal digits
   */
  String id();

  /**
   * How far it got.
   *
   * @return the phase now
   */
  Ros2GoalPhase phase();

  /**
   * The end of the goal.
   *
   * @return completes once, on the thread that calls {@link Ros2GoalListener#onDone}, after it
   */
  CompletionStage<Ros2GoalOutcome> done();

  /**
   * Asks the server to cancel this goal and no other; does not wait. Does nothing once it ended. The server decides how
   * the goal ends.
   */
  void cancel();
}
