package org.robotui.ros2.action;

import java.time.Duration;
import java.util.Map;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.internal.action.ActionClientLinks;
import org.robotui.ros2.name.Ros2Name;

/** Sends goals to the server of one action. Any thread may use it. */
public interface Ros2ActionClient extends AutoCloseable {

  /**
   * Makes the clients of the action's services and subscribes to its topics. The server need not be there yet.
   *
   * @param node the node; the client must be closed before it
   * @param action the action's name
   * @param type the action's type, see {@link org.robotui.ros2.Ros2Types#action}
   * @param options what the owner gives it
   * @return the client
   */
  static Ros2ActionClient open(Ros2Node node, String action, TypedAction type, Ros2ActionOptions options) {
    return new ActionClientLinks(node, action, type, options);
  }

  /**
   * The action.
   *
   * @return its whole name
   */
  Ros2Name name();

  /**
   * The action's type.
   *
   * @return the type goals are made of
   */
  TypedAction type();

  /**
   * Whether there is a server.
   *
   * @return as of now
   */
  boolean ready();

  /**
   * Waits until there is a server.
   *
   * @param patience how long at most
   * @return whether there is one
   */
  boolean awaitServer(Duration patience);

  /**
   * Waits until there is a server, sends it a goal, once, and waits until it says whether it takes it.
   *
   * @param goal the goal's values by field name, as {@link org.robotui.message.DynamicCodec#build} takes them
   * @param listener hears of this goal
   * @param patience for all of it
   * @return the goal; refused if the values do not fit, the server does not want it, or too many goals are on their way
   */
  Outcome<Ros2GoalHandle> send(Map<String, ?> goal, Ros2GoalListener listener, Duration patience);

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
