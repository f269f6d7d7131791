package org.robotui.rfic.ros.internal.call;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.Browser.Description;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.CallException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.data.MessageShapes;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceIdentity;
import org.robotui.ros.SystemState;
import org.robotui.ros.action.ActionType;

/** Describes single things of a ROS robot. */
final class RosDescriber {
  private static final Duration PATIENCE = Duration.ofSeconds(3);
  private static final String PARTS = "\n---\n";

  private final RosNode node;
  private final MessageRegistry registry;

  RosDescriber(RosNode node, MessageRegistry registry) {
    this.node = node;
    this.registry = registry;
  }

  Description topic(Item item, SystemState state) {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", item.type());
    facts.put("publishers", joined(state.publishers().getOrDefault(item.name(), List.of())));
    facts.put("subscribers", joined(state.subscribers().getOrDefault(item.name(), List.of())));
    Optional<MessageSchema> schema = found(registry.message(item.type()), facts);
    return new Description(item, facts, schema.map(RosDescriber::text), schema.map(MessageShapes::of),
        Optional.empty());
  }

  Description service(Item item) throws CallException {
    Map<String, String> facts = new LinkedHashMap<>();
    ServiceIdentity identity = Outcomes.value(node.probeService(item.name(), PATIENCE));
    facts.put("type", identity.type());
    facts.put("node", identity.node());
    Item typed = new Item(item.kind(), item.name(), identity.type());
    Optional<ServiceSchema> schema = found(registry.service(identity.type(), identity.md5()), facts);
    return new Description(typed, facts, schema.map(s -> text(s.request()) + PARTS + text(s.response())),
        schema.map(ServiceSchema::request).map(MessageShapes::of),
        schema.map(ServiceSchema::response).map(MessageShapes::of));
  }

  /** The type of an action is that of its goal, result and feedback together: only the parts are messages. */
  Description action(Item item, SystemState state) {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", item.type());
    facts.put("servers", joined(state.subscribers().getOrDefault(item.name() + "/goal", List.of())));
    facts.put("clients", joined(state.publishers().getOrDefault(item.name() + "/goal", List.of())));
    Optional<ActionType> type = found(ActionType.find(item.type(), registry), facts);
    Optional<String> definition = type.map(t -> Stream.of(t.goal(), t.result(), t.feedback()).map(RosDescriber::text)
        .collect(Collectors.joining(PARTS)));
    return new Description(item, facts, definition, type.map(ActionType::goal).map(MessageShapes::of),
        type.map(ActionType::result).map(MessageShapes::of));
  }

  Description robotNode(Item item, SystemState state) throws CallException {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("address", Outcomes.value(node.master().lookupNode(item.name())));
    facts.put("publishes", joined(of(state.publishers(), item.name())));
    facts.put("subscribes", joined(of(state.subscribers(), item.name())));
    facts.put("services", joined(of(state.services(), item.name())));
    return plain(item, facts);
  }

  static Description plain(Item item, Map<String, String> facts) {
    return new Description(item, facts, Optional.empty(), Optional.empty(), Optional.empty());
  }

  private static <S> Optional<S> found(SchemaLookup<S> lookup, Map<String, String> facts) {
    return switch (lookup) {
      case SchemaLookup.Found<S> f -> Optional.of(f.schema());
      case SchemaLookup.Missing<S> m -> {
        facts.put("definition", m.reason());
        yield Optional.empty();
      }
    };
  }

  private static String text(MessageSchema schema) {
    return schema.info().definition();
  }

  private static List<String> of(Map<String, List<String>> nodesByName, String node) {
    return nodesByName.entrySet().stream().filter(e -> e.getValue().contains(node)).map(Map.Entry::getKey).sorted()
        .toList();
  }

  private static String joined(List<String> names) {
    return names.isEmpty() ? "none" : String.join(", ", names);
  }
}
