package org.robotui.rfic.rosbridge.internal.call;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.api.port.CallException;
import org.robotui.message.Generation;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.rfic.rosbridge.internal.session.RosApiWatch;
import org.robotui.rosbridge.RosApi;
import org.robotui.rosbridge.RosbridgeClient;

/**
 * The parameters behind a bridge: of ROS 1 those that rosapi has of the master, of ROS 2 those of each node, asked of
 * the node. Safe for all threads; questions wait for the answer.
 */
public final class BridgeParameters {
  private static final Duration PATIENCE = Duration.ofSeconds(3);

  private final RosApi api;
  private final NodesOfRos2 nodes;
  private final RosApiWatch watch;

  /**
   * Has asked nobody yet.
   *
   * @param client calls services of nodes
   * @param api knows parameters of ROS 1
   * @param watch knows which ROS it is
   */
  public BridgeParameters(RosbridgeClient client, RosApi api, RosApiWatch watch) {
    this.api = api;
    this.nodes = new NodesOfRos2(
        (service, arguments) -> CallOutcomes.asked(() -> client.call(service, arguments, PATIENCE)),
        () -> CallOutcomes.asked(api::services));
    this.watch = watch;
  }

  private boolean isOfNodes() {
    return watch.graph().generation() == Generation.ROS2;
  }

  List<String> names() throws CallException {
    return isOfNodes() ? nodes.parameters() : CallOutcomes.asked(api::parameters);
  }

  /** Its value as the bridge writes it; none where there is no such parameter. */
  Optional<Object> value(String name) throws CallException {
    return isOfNodes() ? nodes.value(name) : CallOutcomes.asked(() -> api.parameter(name));
  }

  void set(String name, Object value) throws CallException {
    if (isOfNodes()) {
      nodes.set(name, value);
    } else if (!CallOutcomes.asked(() -> api.set(name, value))) {
      throw new CallException(name + " was not set");
    }
  }
}
