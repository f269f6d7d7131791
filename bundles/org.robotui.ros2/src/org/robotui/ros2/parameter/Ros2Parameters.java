package org.robotui.ros2.parameter;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.internal.parameter.ParameterClient;
import org.robotui.ros2.name.Ros2Name;

/** The parameters of another node. Calls wait for it; any thread may make them but the receiving one. */
public interface Ros2Parameters extends AutoCloseable {

  /**
   * Prepares to ask a node.
   *
   * @param asking asks; this must be closed before it
   * @param asked whose parameters
   * @param timeout for each call
   * @return them
   */
  static Ros2Parameters open(Ros2Node asking, Ros2Name asked, Duration timeout) {
    return new ParameterClient(asking, asked, timeout);
  }

  /**
   * Follows the parameters of all nodes.
   *
   * @param node listens
   * @param listener hears what changed; called on the receiving thread, must not block
   * @return closing it ends the subscription
   */
  static AutoCloseable follow(Ros2Node node, Consumer<Ros2ParameterEvent> listener) {
    return ParameterClient.follow(node, listener);
  }

  /**
   * The node.
   *
   * @return its whole name
   */
  Ros2Name node();

  /**
   * All parameters.
   *
   * @return their names
   */
  Outcome<List<String>> names();

  /**
   * Reads parameters.
   *
   * @param names which ones
   * @return their values by name; {@link Ros2ParameterValue.Unset} for those that the node does not have
   */
  Outcome<Map<String, Ros2ParameterValue>> get(List<String> names);

  /**
   * Describes parameters.
   *
   * @param names which ones
   * @return what they are and may be, by name
   */
  Outcome<Map<String, Ros2ParameterDescriptor>> describe(List<String> names);

  /**
   * Sets a parameter.
   *
   * @param name its name
   * @param value its new value
   * @return done, or refused in the node's words
   */
  Outcome<Boolean> set(String name, Ros2ParameterValue value);

  /**
   * Sets several parameters, or none of them.
   *
   * @param values new values by name
   * @return done, or refused in the node's words
   */
  Outcome<Boolean> setAll(Map<String, Ros2ParameterValue> values);

  /** Takes the clients back from the network. */
  @Override
  void close();
}
