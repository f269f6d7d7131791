package org.robotui.ros.reconfigure;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;

/** Follows one server. Any thread may use it. */
public interface ReconfigureClient extends AutoCloseable {

  /**
   * Subscribes to what the server says. It need not be there yet.
   *
   * @param node the node; the client must be closed before it
   * @param server the server's name, usually that of a node
   * @param listener hears of the server
   * @return the client
   * @throws IllegalStateException if the node is closed
   */
  static ReconfigureClient open(RosNode node, GraphName server, ReconfigureListener listener) {
    return new ReconfigureLinks(node, server, listener);
  }

  /**
   * What the server offers.
   *
   * @return empty until the server described it
   */
  Optional<ServerDescription> description();

  /**
   * The values as the server told them last.
   *
   * @return empty until it told them
   */
  Optional<ConfigValues> values();

  /**
   * Waits until the server described its parameters and told their values.
   *
   * @param patience how long at most
   * @return whether it did
   */
  boolean await(Duration patience);

  /**
   * Asks for other values. The server may correct them: it keeps numbers within their limits.
   *
   * @param changes Java values by parameter name, as {@link ConfigValue#of} reads them; the other parameters stay
   * @param timeout for the whole call
   * @return all values as they are now; refused, without a call, if there is no such parameter or a value does not fit,
   * or if the description did not come yet
   */
  Outcome<ConfigValues> set(Map<String, ?> changes, Duration timeout);

  /** Ends all links. */
  @Override
  void close();
}
