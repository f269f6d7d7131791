package org.robotui.ros2;

import java.io.IOException;
import org.robotui.ros2.graph.Ros2Graph;
import org.robotui.ros2.internal.context.ContextRuntime;
import org.robotui.rtps.Participant;

/**
 * One process in a domain of ROS 2, as others see it: a participant of DDS with any number of nodes. Several contexts
 * of one process may share a participant, see {@link Ros2Participants}. Any thread may use it.
 */
public interface Ros2Context extends AutoCloseable {

  /**
   * Opens a context and begins to look for others.
   *
   * @param environment the surroundings
   * @param options what the owner gives it
   * @return the open context
   * @throws IOException if a socket cannot be opened; the message says which and what may help
   */
  static Ros2Context open(Ros2Environment environment, Ros2Options options) throws IOException {
    return ContextRuntime.open(environment, options);
  }

  /**
   * Makes a context on a participant, which the context closes.
   *
   * @param participant takes part in the domain
   * @param environment the surroundings, of which the participant was made
   * @param options what the owner gives it
   * @return the open context
   */
  static Ros2Context on(Participant participant, Ros2Environment environment, Ros2Options options) {
    return ContextRuntime.on(participant, environment, options);
  }

  /**
   * Adds a node.
   *
   * @param name its base name; a remapping of {@code __node} wins
   * @return the open node
   * @throws IllegalArgumentException if it is no name
   * @throws IllegalStateException if its participant has a node of that name, or this is closed
   */
  Ros2Node node(String name);

  /**
   * Who is there and has what.
   *
   * @return the same object always
   */
  Ros2Graph graph();

  /**
   * The types of the domain.
   *
   * @return the same object always
   */
  Ros2Types types();

  /**
   * The participant below, for what this library has no words for.
   *
   * @return the participant, which is closed with the last context that takes part by it
   */
  Participant participant();

  /** Closes all nodes, says farewell and ends the threads, in less than two seconds. */
  @Override
  void close();
}
