package org.robotui.ros.action;

import java.util.concurrent.CompletionStage;

/** A goal that was sent. Any thread may use it. */
public interface GoalHandle {

  /**
   * The goal's name.
   *
   * @return unique over all goals of the graph
   */
  String id();

  /**
   * How far it got.
   *
   * @return the phase now
   */
  GoalPhase phase();

  /**
   * The end of the goal.
   *
   * @return completes once, on the thread that calls {@link GoalListener#onDone}, after it
   */
  CompletionStage<GoalOutcome> done();

  /**
   * Asks the server to cancel this goal and no other. Does nothing once it ended. The server decides how the goal ends.
   */
  void cancel();
}
