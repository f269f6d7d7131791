package org.robotui.rfic.ros2.internal.call;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robotui.api.port.CallException;
import org.robotui.message.description.TypeName;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.message.topic.KeptWhileAsked;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.graph.GraphService;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterValue;
import org.robotui.ros2.parameter.Ros2Parameters;

/**
 * The parameters of the robot's nodes. Our ends of a node's services are kept from the first question until nobody has
 * asked for a while. Safe for all threads; questions wait for the node.
 */
public final class NodeParameters implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(3);
  private static final TypeName ASKED = new TypeName("rcl_interfaces", TypeName.Kind.SRV, "ListParameters");

  private final Ros2Node asking;
  private final KeptWhileAsked<Ros2Name, Ros2Parameters> clients;

  /**
   * A parameter with all that its node says of it.
   *
   * @param value its value
   * @param descriptor what it is and may be
   */
  record Known(Ros2ParameterValue value, Ros2ParameterDescriptor descriptor) {}

  /**
   * Has asked nobody yet.
   *
   * @param asking asks
   */
  public NodeParameters(Ros2Node asking) {
    this.asking = asking;
    this.clients = new KeptWhileAsked<>(node -> Ros2Parameters.open(asking, node, PATIENCE), Ros2Parameters::close);
  }

  /** The nodes that have parameters. */
  List<Ros2Name> nodes() {
    return asking.context().graph().state().services().stream()
        .filter(service -> service.servers().stream().anyMatch(end -> !end.own()) && !service.name().hidden()
            && service.type().filter(ASKED::equals).isPresent())
        .map(GraphService::name).map(Ros2Name::namespace).sorted().toList();
  }

  /** The names of a node's parameters. */
  List<String> names(Ros2Name node) throws CallException {
    return CallOutcomes.value(clients.of(node).names());
  }

  /** Some parameters of a node, in the order of their names; those that it does not have are left out. */
  Map<String, Known> read(Ros2Name node, List<String> names) throws CallException {
    Ros2Parameters parameters = clients.of(node);
    Map<String, Ros2ParameterValue> values = CallOutcomes.value(parameters.get(names));
    List<String> there = new ArrayList<>(names);
    there.removeIf(name -> values.getOrDefault(name, new Ros2ParameterValue.Unset()).type() == 0);
    Map<String, Ros2ParameterDescriptor> described =
        there.isEmpty() ? Map.of() : CallOutcomes.value(parameters.describe(there));
    Map<String, Known> known = new TreeMap<>();
    there.forEach(name -> {
      Ros2ParameterValue value = values.get(name);
      known.put(name, new Known(value,
          described.getOrDefault(name, Ros2ParameterDescriptor.of(name, value, ""))));
    });
    return known;
  }

  /** Sets parameters of a node, all or none. */
  void set(Ros2Name node, Map<String, Ros2ParameterValue> values) throws CallException {
    CallOutcomes.value(values.size() == 1
        ? clients.of(node).set(values.keySet().iterator().next(), values.values().iterator().next())
        : clients.of(node).setAll(values));
  }

  /** Gives up the ends of those of whom nobody has asked for a while. */
  public void tick() {
    clients.tick();
  }

  @Override
  public void close() {
    clients.close();
  }
}
