package org.robotui.rfic.ros2.internal.call;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.api.port.Browser.Description;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.CallException;
import org.robotui.message.MessageSchema;
import org.robotui.message.description.TypeName;
import org.robotui.message.topic.ItemFacts;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Types;
import org.robotui.ros2.graph.GraphAction;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.graph.GraphNode;
import org.robotui.ros2.graph.GraphService;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.graph.GraphTopic;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Qos;

/** Describes single things of a ROS 2 robot. Asks its nodes for the definitions of types that are not known here. */
final class Ros2Describer {
  private static final Duration PATIENCE = Duration.ofSeconds(3);

  private final Ros2Node node;

  Ros2Describer(Ros2Node node) {
    this.node = node;
  }

  private Ros2Types types() {
    return node.context().types();
  }

  Description topic(Item item, GraphState state) throws CallException {
    Ros2Name name = Ros2Services.name(item.name());
    Optional<GraphTopic> topic = state.topic(name);
    ItemFacts facts = new ItemFacts().with("type", topic.map(t -> String.join(", ", t.types())).orElse(item.type()));
    ends(facts, "publishers", topic.map(GraphTopic::publishers));
    ends(facts, "subscribers", topic.map(GraphTopic::subscribers));
    topic.ifPresent(t -> quality(facts, t));
    Optional<MessageSchema> schema =
        facts.found(types().topic(name, PATIENCE)).map(Ros2Types.TypedMessage::schema);
    return facts.ofMessage(item, schema);
  }

  private static void ends(ItemFacts facts, String what, Optional<List<GraphEnd>> ends) {
    facts.with(what, ends.orElse(List.of()).stream().map(GraphEnd::who).distinct().sorted().toList());
  }

  /** The quality of service of each end, and the pairs that do not hear each other. */
  private static void quality(ItemFacts facts, GraphTopic topic) {
    topic.publishers().forEach(end -> facts.with(end.who() + " offers", QosProfiles.sentence(end.qos())));
    topic.subscribers().forEach(end -> facts.with(end.who() + " asks for", QosProfiles.sentence(end.qos())));
    List<String> apart = new ArrayList<>();
    topic.publishers().forEach(from -> topic.subscribers().forEach(to -> {
      List<String> reasons = Qos.mismatch(from.qos(), to.qos());
      if (!reasons.isEmpty()) {
        apart.add(to.who() + " does not hear " + from.who() + ": " + String.join("; ", reasons));
      }
    }));
    if (!apart.isEmpty()) {
      facts.with("mismatch", String.join("; ", apart));
    }
  }

  Description service(Item item, GraphState state) throws CallException {
    Ros2Name name = Ros2Services.name(item.name());
    Optional<GraphService> service = state.service(name);
    ItemFacts facts = new ItemFacts()
        .with("type", service.flatMap(GraphService::type).map(TypeName::toString).orElse(item.type()));
    ends(facts, "servers", service.map(GraphService::servers));
    ends(facts, "clients", service.map(GraphService::clients));
    return facts.ofCall(item, facts.found(types().service(name)).map(Ros2Types.TypedService::schema)
        .map(s -> List.of(s.request(), s.response())).orElse(List.of()));
  }

  Description action(Item item, GraphState state) throws CallException {
    Ros2Name name = Ros2Services.name(item.name());
    Optional<GraphAction> action = state.action(name);
    ItemFacts facts = new ItemFacts()
        .with("type", action.flatMap(GraphAction::type).map(TypeName::toString).orElse(item.type()));
    ends(facts, "servers", action.map(GraphAction::servers));
    ends(facts, "clients", action.map(GraphAction::clients));
    return facts.ofCall(item, facts.found(types().action(name)).map(Ros2Types.TypedAction::schema)
        .map(s -> List.of(s.goal(), s.result(), s.feedback())).orElse(List.of()));
  }

  Description program(Item item, GraphState state) {
    ItemFacts facts = new ItemFacts();
    Optional<GraphNode> known = Ros2Name.parse(item.name()).flatMap(state::node);
    facts.with("process", known.map(n -> n.participant().toString()).orElse(item.name()));
    known.ifPresent(n -> facts.with("DDS", n.vendor().toString()));
    facts.with("publishes", of(state.topics(), item, GraphTopic::publishers, GraphTopic::name));
    facts.with("subscribes", of(state.topics(), item, GraphTopic::subscribers, GraphTopic::name));
    facts.with("services", of(state.services(), item, GraphService::servers, GraphService::name));
    facts.with("actions", of(state.actions(), item, GraphAction::servers, GraphAction::name));
    known.ifPresent(n -> LifecycleFacts.add(facts, node, n.name(), state));
    return facts.plain(item);
  }

  private static <T> List<String> of(List<T> things, Item program, Function<T, List<GraphEnd>> ends,
      Function<T, Ros2Name> name) {
    return things.stream().filter(thing -> ends.apply(thing).stream().anyMatch(end -> is(end, program)))
        .map(thing -> name.apply(thing).text()).toList();
  }

  private static boolean is(GraphEnd end, Item program) {
    return end.node().map(Ros2Name::text).orElseGet(() -> end.guid().participant().toString()).equals(program.name());
  }
}
