package org.robotui.ros2.lifecycle;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.internal.LifecycleClient;
import org.robotui.ros2.name.Ros2Name;

/** The life cycle of another node. Calls wait for it; any thread may make them but the receiving one. */
public interface Ros2Lifecycle extends AutoCloseable {

  /**
   * Prepares to ask a node.
   *
   * @param asking asks; this must be closed before it
   * @param asked whose life cycle
   * @return it
   */
  static Ros2Lifecycle open(Ros2Node asking, Ros2Name asked) {
    return new LifecycleClient(asking, asked);
  }

  /**
   * The nodes that have a life cycle.
   *
   * @param graph who is there
   * @return their names, sorted
   */
  static List<Ros2Name> nodes(GraphState graph) {
    return graph.services().stream().filter(service -> !service.servers().isEmpty())
        .filter(service -> service.type().filter(LifecycleClient.CHANGE_STATE::equals).isPresent())
        .map(service -> service.name().namespace()).sorted().toList();
  }

  /**
   * The node.
   *
   * @return its whole name
   */
  Ros2Name node();

  /**
   * The state that it is in.
   *
   * @param timeout for the call
   * @return the state
   */
  Outcome<LifecycleState> state(Duration timeout);

  /**
   * What it can do next.
   *
   * @param timeout for the call
   * @return the changes that it offers in its state
   */
  Outcome<List<LifecycleTransition>> transitions(Duration timeout);

  /**
   * Changes its state.
   *
   * @param transition the number of one that it offers
   * @param timeout for the call, during which the node does its work
   * @return done, or refused if the node could not
   */
  Outcome<Boolean> change(int transition, Duration timeout);

  /**
   * Follows its state.
   *
   * @param listener hears of each change; called on the receiving thread, must not block
   * @return closing it ends the subscription
   */
  AutoCloseable follow(Consumer<LifecycleTransition> listener);

  /** Takes the clients back from the network. */
  @Override
  void close();
}
