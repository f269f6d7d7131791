package org.robotui.rfic.ros.internal.call;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.message.topic.ItemFacts;
import org.robotui.ros.RosNode;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;
import org.robotui.ros.action.Actions;
import org.robotui.ros.reconfigure.ReconfigureServers;

/** What a ROS robot has, as its master and its nodes say. */
public final class RosBrowser implements Browser {
  private final RosNode node;
  private final RosTunables tunables;
  private final RosDescriber describer;

  /**
   * Creates a browser.
   *
   * @param node asks
   * @param registry knows definitions
   * @param tunables reads settings of running nodes
   */
  public RosBrowser(RosNode node, MessageRegistry registry, RosTunables tunables) {
    this.node = node;
    this.tunables = tunables;
    this.describer = new RosDescriber(node, registry);
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    return switch (kind) {
      case TOPIC -> topics(state()).entrySet().stream().map(e -> new Item(kind, e.getKey(), e.getValue())).toList();
      case SERVICE -> named(kind, state().services().keySet().stream());
      case NODE -> named(kind, state().nodes().stream());
      case PARAMETER -> named(kind, CallOutcomes.value(node.parameters().names()).stream());
      case ACTION -> actions();
      case TUNABLE -> named(kind, CallOutcomes.value(ReconfigureServers.list(node.master())).stream());
    };
  }

  private Map<String, String> topics(SystemState state) throws CallException {
    Map<String, String> types = new TreeMap<>();
    Stream.of(state.publishers(), state.subscribers()).forEach(m -> m.keySet().forEach(t -> types.put(t, "")));
    for (TopicInfo t : CallOutcomes.value(node.master().topicTypes())) {
      types.computeIfPresent(t.name(), (name, old) -> t.type());
    }
    return types;
  }

  private List<Item> actions() throws CallException {
    return CallOutcomes.value(Actions.list(node.master())).stream()
        .map(a -> new Item(Kind.ACTION, a.name().text(), a.type())).toList();
  }

  private static List<Item> named(Kind kind, Stream<String> names) {
    return names.sorted().map(n -> new Item(kind, n, "")).toList();
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case TOPIC -> describer.topic(item, state());
      case SERVICE -> describer.service(item);
      case NODE -> describer.robotNode(item, state());
      case ACTION -> describer.action(item, state());
      case TUNABLE -> new ItemFacts().with("service", item.name() + "/set_parameters").plain(item);
      case PARAMETER -> new ItemFacts()
          .with("value", parameter(item.name()).map(Object::toString).orElse("not set")).plain(item);
    };
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    return CallOutcomes.value(node.parameters().has(name))
        ? Optional.of(ParameterValues.plain(CallOutcomes.value(node.parameters().get(name))))
        : Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    CallOutcomes.value(node.parameters().set(name, ParameterValues.ros(value)));
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    return tunables.read(item.name());
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    return tunables.change(item.name(), values);
  }

  @Override
  public List<Link> links() throws CallException {
    SystemState state = state();
    return Stream.concat(ends(state.publishers(), true), ends(state.subscribers(), false)).toList();
  }

  private static Stream<Link> ends(Map<String, List<String>> nodesByTopic, boolean sends) {
    return nodesByTopic.entrySet().stream()
        .flatMap(topic -> topic.getValue().stream().distinct().map(node -> new Link(node, topic.getKey(), sends)));
  }

  private SystemState state() throws CallException {
    return CallOutcomes.value(node.master().systemState());
  }
}
