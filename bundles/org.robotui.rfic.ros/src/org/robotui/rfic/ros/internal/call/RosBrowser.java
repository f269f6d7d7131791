package org.robotui.rfic.ros.internal.call;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.ros.Outcome;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceIdentity;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;
import org.robotui.ros.message.MessageRegistry;
import org.robotui.ros.message.MessageSchema;
import org.robotui.ros.message.SchemaLookup;

/** What a ROS robot has, as its master and its nodes say. */
public final class RosBrowser implements Browser {
  private static final Duration PATIENCE = Duration.ofSeconds(3);

  private final RosNode node;
  private final MessageRegistry registry;

  /**
   * Creates a browser.
   *
   * @param node asks
   * @param registry knows definitions
   */
  public RosBrowser(RosNode node, MessageRegistry registry) {
    this.node = node;
    this.registry = registry;
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    return switch (kind) {
      case TOPIC -> topics();
      case SERVICE -> named(kind, state().services().keySet().stream());
      case NODE -> named(kind, state().nodes().stream());
      case PARAMETER -> named(kind, value(node.parameters().names()).stream());
    };
  }

  private List<Item> topics() throws CallException {
    Map<String, String> types = new TreeMap<>();
    SystemState state = state();
    Stream.of(state.publishers(), state.subscribers()).forEach(m -> m.keySet().forEach(t -> types.put(t, "")));
    for (TopicInfo t : value(node.master().topicTypes())) {
      types.computeIfPresent(t.name(), (name, old) -> t.type());
    }
    return types.entrySet().stream().map(e -> new Item(Kind.TOPIC, e.getKey(), e.getValue())).toList();
  }

  private static List<Item> named(Kind kind, Stream<String> names) {
    return names.sorted().map(n -> new Item(kind, n, "")).toList();
  }

  @Override
  public Description describe(Item item) throws CallException {
    Map<String, String> facts = new LinkedHashMap<>();
    Optional<String> definition = switch (item.kind()) {
      case TOPIC -> topic(item, facts);
      case SERVICE -> service(item, facts);
      case NODE -> robotNode(item, facts);
      case PARAMETER -> parameter(item, facts);
    };
    return new Description(item, facts, definition);
  }

  private Optional<String> topic(Item item, Map<String, String> facts) throws CallException {
    SystemState state = state();
    facts.put("type", item.type());
    facts.put("publishers", joined(state.publishers().getOrDefault(item.name(), List.of())));
    facts.put("subscribers", joined(state.subscribers().getOrDefault(item.name(), List.of())));
    return switch (registry.message(item.type())) {
      case SchemaLookup.Found<MessageSchema> f -> Optional.of(f.schema().info().definition());
      case SchemaLookup.Missing<MessageSchema> m -> {
        facts.put("definition", m.reason());
        yield Optional.empty();
      }
    };
  }

  private Optional<String> service(Item item, Map<String, String> facts) throws CallException {
    ServiceIdentity identity = value(node.probeService(item.name(), PATIENCE));
    facts.put("type", identity.type());
    facts.put("node", identity.node());
    return switch (registry.service(identity.type(), identity.md5())) {
      case SchemaLookup.Found<org.robotui.ros.message.ServiceSchema> f -> Optional.of(
          f.schema().request().info().definition() + "\n---\n" + f.schema().response().info().definition());
      case SchemaLookup.Missing<org.robotui.ros.message.ServiceSchema> m -> {
        facts.put("definition", m.reason());
        yield Optional.empty();
      }
    };
  }

  private Optional<String> robotNode(Item item, Map<String, String> facts) throws CallException {
    SystemState state = state();
    facts.put("address", value(node.master().lookupNode(item.name())));
    facts.put("publishes", joined(of(state.publishers(), item.name())));
    facts.put("subscribes", joined(of(state.subscribers(), item.name())));
    facts.put("services", joined(of(state.services(), item.name())));
    return Optional.empty();
  }

  private Optional<String> parameter(Item item, Map<String, String> facts) throws CallException {
    facts.put("value", parameter(item.name()).map(Object::toString).orElse("not set"));
    return Optional.empty();
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    return value(node.parameters().has(name)) ? Optional.of(ParameterValues.plain(value(node.parameters().get(name)))) : Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    value(node.parameters().set(name, ParameterValues.ros(value)));
  }

  private SystemState state() throws CallException {
    return value(node.master().systemState());
  }

  private static List<String> of(Map<String, List<String>> nodesByName, String node) {
    return nodesByName.entrySet().stream().filter(e -> e.getValue().contains(node)).map(Map.Entry::getKey).sorted().toList();
  }

  private static String joined(List<String> names) {
    return names.isEmpty() ? "none" : String.join(", ", names);
  }

  private static <T> T value(Outcome<T> outcome) throws CallException {
    return outcome.toOptional().orElseThrow(() -> new CallException(outcome.reason()));
  }
}
