package org.robotui.rfic.ros.internal.call;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Browser.Description;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.CallException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.ServiceSchema;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.message.topic.ItemFacts;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceIdentity;
import org.robotui.ros.SystemState;
import org.robotui.ros.action.ActionType;

/** Describes single things of a ROS robot. */
final class RosDescriber {
  private static final Duration PATIENCE = Duration.ofSeconds(3);

  private final RosNode node;
  private final MessageRegistry registry;

  RosDescriber(RosNode node, MessageRegistry registry) {
    this.node = node;
    this.registry = registry;
  }

  Description topic(Item item, SystemState state) {
    ItemFacts facts = new ItemFacts().with("type", item.type())
        .with("publishers", state.publishers().getOrDefault(item.name(), List.of()))
        .with("subscribers", state.subscribers().getOrDefault(item.name(), List.of()));
    return facts.ofMessage(item, facts.found(registry.message(item.type())));
  }

  Description service(Item item) throws CallException {
    ServiceIdentity identity = CallOutcomes.value(node.probeService(item.name(), PATIENCE));
    ItemFacts facts = new ItemFacts().with("type", identity.type()).with("node", identity.node());
    Optional<ServiceSchema> schema = facts.found(registry.service(identity.type(), identity.md5()));
    return facts.ofCall(new Item(item.kind(), item.name(), identity.type()),
        schema.map(s -> List.of(s.request(), s.response())).orElse(List.of()));
  }

  /** The type of an action is that of its goal, result and feedback together: only the parts are messages. */
  Description action(Item item, SystemState state) {
    ItemFacts facts = new ItemFacts().with("type", item.type())
        .with("servers", state.subscribers().getOrDefault(item.name() + "/goal", List.of()))
        .with("clients", state.publishers().getOrDefault(item.name() + "/goal", List.of()));
    Optional<ActionType> type = facts.found(ActionType.find(item.type(), registry));
    return facts.ofCall(item, type.map(t -> List.of(t.goal(), t.result(), t.feedback())).orElse(List.of()));
  }

  Description robotNode(Item item, SystemState state) throws CallException {
    return new ItemFacts().with("address", CallOutcomes.value(node.master().lookupNode(item.name())))
        .with("publishes", of(state.publishers(), item.name()))
        .with("subscribes", of(state.subscribers(), item.name()))
        .with("services", of(state.services(), item.name())).plain(item);
  }

  private static List<String> of(Map<String, List<String>> nodesByName, String node) {
    return nodesByName.entrySet().stream().filter(e -> e.getValue().contains(node)).map(Map.Entry::getKey).sorted()
        .toList();
  }
}
