package org.robotui.ros.action;

import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;

/** An action that a node of ours serves to clients of actionlib. Any thread may use it. */
public interface ActionServer extends AutoCloseable {

  /** How long goals that have ended are mentioned among the others. */
  int MENTIONED_SECONDS = 5;

  /**
   * Serves an action. Several goals may be on their way at once; it is the taker that replaces one by another.
   *
   * @param node the node; the server must be closed before it
   * @param action the action's name
   * @param type the action's type
   * @param taker works on goals
   * @return the server
   * @throws IllegalStateException if this node serves the action already, or is closed
   */
  static ActionServer open(RosNode node, GraphName action, ActionWire type, GoalTaker taker) {
    return new ActionServerTopics(node, action, type, taker);
  }

  /**
   * The action.
   *
   * @return its global name
   */
  GraphName name();

  /**
   * Says how all goals stand, five times a second at most. To be called at least as often: clients give up a server
   * that is silent for some seconds.
   */
  void tick();

  /** Asks for the end of all goals, and leaves the topics. */
  @Override
  void close();
}
