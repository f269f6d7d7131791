package org.robotui.ros2.parameter;

import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.internal.parameter.ParameterHost;

/** The parameters that a node of ours offers to others. Any thread may use it. */
public interface Ros2ParameterServer extends AutoCloseable {

  /**
   * Offers none yet, but the six services about them.
   *
   * @param node whose parameters; this must be closed before it
   * @return the server
   */
  static Ros2ParameterServer open(Ros2Node node) {
    return new ParameterHost(node);
  }

  /**
   * Adds a parameter.
   *
   * @param descriptor what it is and may be
   * @param value its first value
   * @param judge says why a value cannot be set, empty if it can; called on a thread of a service, before the value is
   * there
   * @throws IllegalArgumentException if there is one of that name
   */
  void declare(Ros2ParameterDescriptor descriptor, Ros2ParameterValue value,
      Function<Ros2ParameterValue, Optional<String>> judge);

  /**
   * The value of a parameter.
   *
   * @param name its name
   * @return {@link Ros2ParameterValue.Unset} if there is none of that name
   */
  Ros2ParameterValue value(String name);

  /**
   * Sets a parameter from this side; others hear of it.
   *
   * @param name its name
   * @param value its new value
   * @throws IllegalArgumentException if there is none of that name, or it may not have that value
   */
  void set(String name, Ros2ParameterValue value);

  /**
   * Listens to what is set, from either side.
   *
   * @param listener hears of the new values by name, all that were set at once together; called when they are there,
   * under a lock of the server, so that it must not block
   */
  void onSet(Consumer<Map<String, Ros2ParameterValue>> listener);

  /** Takes the services back from the network. */
  @Override
  void close();
}
