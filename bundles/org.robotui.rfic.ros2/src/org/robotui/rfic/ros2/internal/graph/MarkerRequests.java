package org.robotui.rfic.ros2.internal.graph;

import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersRequest;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersResponse;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2ServiceClient;
import org.robotui.ros2.Ros2ServiceCodec;

/**
 * Asks servers of interactive markers for all that they have: ROS 2 has a service where ROS 1 has a topic. Clients stay
 * open as long as the node. Any thread; never waits.
 */
final class MarkerRequests {
  private static final Ros2ServiceCodec<GetInteractiveMarkersRequest, GetInteractiveMarkersResponse> CODEC =
      Ros2ServiceCodec.of("visualization_msgs/srv/GetInteractiveMarkers", GetInteractiveMarkersRequest.class,
          GetInteractiveMarkersResponse.class);
  private static final int SECONDS = 5;

  private final Ros2Node node;
  private final Map<String, Ros2ServiceClient<GetInteractiveMarkersRequest, GetInteractiveMarkersResponse>> clients =
      new ConcurrentHashMap<>();
  private final Set<String> asked = ConcurrentHashMap.newKeySet();

  MarkerRequests(Ros2Node node) {
    this.node = node;
  }

  /** Asks a server that is there and has nothing left to answer. */
  void ask(String server, Consumer<GetInteractiveMarkersResponse> answer) {
    Ros2ServiceClient<GetInteractiveMarkersRequest, GetInteractiveMarkersResponse> client =
        clients.computeIfAbsent(server, name -> node.serviceClient(name + "/get_interactive_markers", CODEC));
    if (client.ready() && asked.add(server)) {
      // the time is that of a copy: it must not complete what the library completes
      client.send(new GetInteractiveMarkersRequest()).toCompletableFuture().copy()
          .orTimeout(SECONDS, TimeUnit.SECONDS).whenComplete((outcome, late) -> {
            asked.remove(server);
            if (outcome instanceof Outcome.Done<GetInteractiveMarkersResponse> done) {
              answer.accept(done.value());
            }
          });
    }
  }
}
