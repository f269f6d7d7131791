package org.robotui.rfic.rosbridge.internal.call;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.data.record.RecordShape;
import org.robotui.message.DefinitionException;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.data.MessageShapes;
import org.robotui.message.payload.JsonValues;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.rfic.rosbridge.internal.session.BridgeDefinitions;
import org.robotui.rfic.rosbridge.internal.session.BridgeDefinitions.ServiceText;
import org.robotui.rfic.rosbridge.internal.session.RosApiWatch;
import org.robotui.rosbridge.RosApi.NodeDetails;
import org.robotui.rosbridge.RosApi;

/** What a robot behind a bridge has, as rosapi and its nodes say. */
public final class BridgeBrowser implements Browser {
  private final RosApi api;
  private final BridgeDefinitions definitions;
  private final RosApiWatch watch;
  private final BridgeParameters parameters;

  /**
   * Creates a browser.
   *
   * @param api asks
   * @param definitions of messages and services
   * @param watch knows topics and nodes
   * @param parameters of nodes
   */
  public BridgeBrowser(RosApi api, BridgeDefinitions definitions, RosApiWatch watch, BridgeParameters parameters) {
    this.api = api;
    this.definitions = definitions;
    this.watch = watch;
    this.parameters = parameters;
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    return switch (kind) {
      case TOPIC -> new TreeMap<>(watch.browsed().types()).entrySet().stream()
          .map(e -> new Item(kind, e.getKey(), Generation.plainName(e.getValue()))).toList();
      case SERVICE -> named(kind, CallOutcomes.asked(api::services));
      case NODE -> named(kind, List.copyOf(watch.browsed().nodes().keySet()));
      case PARAMETER -> named(kind, parameters.names());
      case ACTION, TUNABLE -> List.of();
    };
  }

  private static List<Item> named(Kind kind, List<String> names) {
    return names.stream().sorted().map(name -> new Item(kind, name, "")).toList();
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case TOPIC -> topic(item);
      case SERVICE -> service(item);
      case NODE -> node(item);
      case PARAMETER -> plain(item, Map.of("value", parameter(item.name()).map(Object::toString).orElse("not set")));
      case ACTION, TUNABLE -> throw new CallException("a bridge has no such thing as " + item.name());
    };
  }

  private Description topic(Item item) throws CallException {
    String type = watch.browsed().types().getOrDefault(item.name(), item.type());
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", type);
    facts.put("publishers", joined(watch.browsed().ends(true).getOrDefault(item.name(), Set.of())));
    facts.put("subscribers", joined(watch.browsed().ends(false).getOrDefault(item.name(), Set.of())));
    String text = CallOutcomes.asked(() -> definitions.message(type));
    return new Description(item, facts, Optional.of(text), shape(type, text), Optional.empty());
  }

  private Description service(Item item) throws CallException {
    String type = CallOutcomes.asked(() -> api.serviceType(item.name()));
    ServiceText text = CallOutcomes.asked(() -> definitions.service(type));
    return new Description(new Item(item.kind(), item.name(), type), Map.of("type", type),
        Optional.of(text.request() + "\n---\n" + text.response()), shape(type + "Request", text.request()),
        shape(type + "Response", text.response()));
  }

  private Description node(Item item) throws CallException {
    NodeDetails details = CallOutcomes.asked(() -> api.node(item.name()));
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("publishes", joined(details.publishing()));
    facts.put("subscribes", joined(details.subscribing()));
    facts.put("services", joined(details.services()));
    return plain(item, facts);
  }

  private static Description plain(Item item, Map<String, String> facts) {
    return new Description(item, facts, Optional.empty(), Optional.empty(), Optional.empty());
  }

  private static Optional<RecordShape> shape(String type, String text) {
    try {
      Generation generation = RosDefinitions.isOfThreeParts(type) ? Generation.ROS2 : Generation.ROS1;
      return Optional.of(MessageShapes.of(MessageSchema.parse(type, text, generation)));
    } catch (DefinitionException e) {
      return Optional.empty();
    }
  }

  private static String joined(Iterable<String> names) {
    String all = String.join(", ", names);
    return all.isEmpty() ? "none" : all;
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    return parameters.value(name).map(JsonValues::listed);
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    parameters.set(name, value);
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException("a bridge has no settings of programs but parameters");
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    return tunables(item);
  }

  @Override
  public List<Link> links() throws CallException {
    List<Link> links = new ArrayList<>();
    watch.browsed().nodes().forEach((node, details) -> {
      details.publishing().forEach(topic -> links.add(new Link(node, topic, true)));
      details.subscribing().forEach(topic -> links.add(new Link(node, topic, false)));
    });
    return links;
  }
}
