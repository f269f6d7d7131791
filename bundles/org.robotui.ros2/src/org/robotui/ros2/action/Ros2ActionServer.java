package org.robotui.ros2.action;

import java.util.concurrent.ThreadFactory;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.internal.action.ActionServerLinks;
import org.robotui.ros2.internal.action.GoalThreads;
import org.robotui.ros2.name.Ros2Name;

/** An action that a node of ours offers. */
public interface Ros2ActionServer extends AutoCloseable {

  /**
   * Offers an action.
   *
   * @param node the node; the server must be closed before it
   * @param action the action's name
   * @param type the action's type
   * @param threads makes one thread for each goal
   * @param worker works on goals
   * @return the server
   */
  static Ros2ActionServer open(Ros2Node node, String action, TypedAction type, ThreadFactory threads,
      Ros2GoalWorker worker) {
    return open(node, action, type, new GoalThreads(node.names().service(action).text(), threads, worker));
  }

  /**
   * Offers an action.
   *
   * @param node the node; the server must be closed before it
   * @param action the action's name
   * @param type the action's type
   * @param taker works on goals
   * @return the server
   */
  static Ros2ActionServer open(Ros2Node node, String action, TypedAction type, Ros2GoalTaker taker) {
    return new ActionServerLinks(node, action, type, taker);
  }

  /**
   * The action.
   *
   * @return its whole name
   */
  Ros2Name name();

  /** Takes it back from the network; goals are told to cancel. */
  @Override
  void close();
}
