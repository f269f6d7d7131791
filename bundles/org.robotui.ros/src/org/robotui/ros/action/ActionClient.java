package org.robotui.ros.action;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.MessageRegistry;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;

/**
 * Sends goals to the server of one action. Any thread may use it. There may be one client for an action at a node, as a
 * node publishes a topic once.
 */
public interface ActionClient extends AutoCloseable {

  /**
   * Publishes and subscribes to the action's topics. The server need not be there yet.
   *
   * @param node the node; the client must be closed before it
   * @param action the action's name
   * @param type the action's type
   * @param registry decodes results and feedback
   * @param options what the owner gives it
   * @return the client
   * @throws IllegalStateException if this node has a client of the action already, or is closed
   */
  static ActionClient open(RosNode node, GraphName action, ActionType type, MessageRegistry registry,
      ActionOptions options) {
    return new ActionLinks(node, action, type, registry, options);
  }

  /**
   * The action.
   *
   * @return its global name
   */
  GraphName name();

  /**
   * The action's type.
   *
   * @return the type goals are made of
   */
  ActionType type();

  /**
   * The server, once all its links stand: it hears goals and cancellations, and its statuses and results are heard.
   *
   * @return its node name
   */
  Optional<String> server();

  /**
   * Waits until there is a server.
   *
   * @param patience how long at most
   * @return whether there is one
   */
  boolean awaitServer(Duration patience);

  /**
   * Waits until there is a server and sends it a goal, once. A goal that cannot be sent in time is not sent at all.
   *
   * @param goal the goal's values by field name, as {@link org.robotui.message.DynamicCodec#build} takes them
   * @param listener hears of this goal
   * @param patience how long to wait for the server
   * @return the goal; refused if the values do not fit or too many goals are on their way; timed out if there is no
   * server
   */
  Outcome<GoalHandle> send(Map<String, ?> goal, GoalListener listener, Duration patience);

  /**
   * Cancels all goals of this client and waits until they ended.
   *
   * @param patience how long at most
   * @return whether they ended
   */
  boolean cancelAll(Duration patience);

  /** Ends all links. Goals on their way go on at the server (see {@link #cancelAll}); here they end as lost. */
  @Override
  void close();
}
