package org.robotui.message.topic;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler.Invocation;

/** Our end of one action of a robot. Any thread may use it. */
public interface ActionRoute extends AutoCloseable {

  /** Opens routes to the actions of a robot. */
  @FunctionalInterface
  interface Opener {

    /**
     * Opens a route.
     *
     * @param action the robot's name of the action
     * @return the route
     * @throws CallException where nobody serves the action, or its type is not known here
     */
    ActionRoute open(String action) throws CallException;
  }

  /** A goal that the robot took. */
  interface Underway {

    /**
     * The end of the goal.
     *
     * @return completes when it has ended
     */
    CompletionStage<ActionReply> done();

    /** Asks the robot to cancel it; does not wait. */
    void cancel();
  }

  /**
   * Sends a goal and waits until the robot takes it.
   *
   * @param goal the fields of the goal by name
   * @param told hears how far it got
   * @param patience how long at most
   * @return the goal
   * @throws CallException where the robot does not take it, with the reason
   */
  Underway send(Map<String, Object> goal, Invocation<ActionRequest> told, Duration patience) throws CallException;

  /**
   * Cancels all goals that were sent by this route, and waits until they have ended.
   *
   * @param patience how long at most
   */
  void cancelAll(Duration patience);

  /** Ends it. Goals go on. */
  @Override
  void close();
}
