package org.robotui.rfic.ros2.internal.call;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Browser.Description;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Tunable;
import org.robotui.api.port.CallException;
import org.robotui.message.topic.ItemFacts;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterValue;

/**
 * The parameters of all nodes, by the name of the node and their own with a slash between them; and those of one node
 * that can be changed in a form: no lists, and none that is read-only.
 */
final class NodeSettings {
  private final NodeParameters parameters;

  /** A parameter of a node. */
  private record Place(Ros2Name node, String name) {}

  NodeSettings(NodeParameters parameters) {
    this.parameters = parameters;
  }

  List<Ros2Name> nodes() {
    return parameters.nodes();
  }

  /** All parameters. A node that does not answer hides none of the others. */
  List<String> all() throws CallException {
    List<String> names = new ArrayList<>();
    Optional<CallException> silent = Optional.empty();
    for (Ros2Name node : nodes()) {
      try {
        parameters.names(node).forEach(name -> names.add(node.text() + "/" + name));
      } catch (CallException e) {
        silent = Optional.of(e);
      }
    }
    if (names.isEmpty() && silent.isPresent()) {
      throw silent.get();
    }
    return names.stream().sorted().toList();
  }

  /** Names of parameters may have slashes as well: the longest name of a node counts. */
  private Optional<Place> place(String name) {
    return nodes().stream().filter(node -> name.startsWith(node.text() + "/"))
        .max(Comparator.comparingInt(node -> node.text().length()))
        .map(node -> new Place(node, name.substring(node.text().length() + 1))).filter(p -> !p.name().isEmpty());
  }

  private Optional<NodeParameters.Known> known(Place place) throws CallException {
    return Optional.ofNullable(parameters.read(place.node(), List.of(place.name())).get(place.name()));
  }

  Optional<Object> value(String name) throws CallException {
    Optional<Place> place = place(name);
    return place.isEmpty() ? Optional.empty() : known(place.get()).map(known -> PlainValues.of(known.value()));
  }

  void set(String name, Object value) throws CallException {
    Place place = place(name).orElseThrow(() -> new CallException("no node is there that has a parameter " + name));
    parameters.set(place.node(), Map.of(place.name(), changed(place, value)));
  }

  private Ros2ParameterValue changed(Place place, Object value) throws CallException {
    NodeParameters.Known known = known(place)
        .orElseThrow(() -> new CallException(place.node() + " has no parameter " + place.name()));
    return PlainValues.like(known.value(), place.name(), value);
  }

  Description describe(Item item) throws CallException {
    ItemFacts facts = new ItemFacts();
    Optional<Place> place = place(item.name());
    Optional<NodeParameters.Known> known = place.isEmpty() ? Optional.empty() : known(place.get());
    facts.with("value", known.map(k -> PlainValues.of(k.value()).toString()).orElse("not set"));
    place.ifPresent(p -> facts.with("node", p.node().text()));
    known.map(NodeParameters.Known::descriptor).ifPresent(d -> rules(facts, d));
    return facts.plain(item);
  }

  private static void rules(ItemFacts facts, Ros2ParameterDescriptor descriptor) {
    if (!descriptor.description().isBlank()) {
      facts.with("description", descriptor.description());
    }
    if (!descriptor.constraints().isBlank()) {
      facts.with("constraints", descriptor.constraints());
    }
    descriptor.doubles().ifPresent(r -> facts.with("range", range(r.from(), r.to(), r.step() == 0, r.step())));
    descriptor.integers().ifPresent(r -> facts.with("range", range(r.from(), r.to(), r.step() == 0, r.step())));
    facts.with("read-only", descriptor.readOnly() ? "yes" : "no");
  }

  private static String range(Object from, Object to, boolean any, Object step) {
    return from + " to " + to + (any ? "" : " in steps of " + step);
  }

  Description describeNode(Item item) {
    return new ItemFacts().with("service", item.name() + "/set_parameters").plain(item);
  }

  List<Tunable> tunables(Ros2Name node) throws CallException {
    List<Tunable> all = new ArrayList<>();
    parameters.read(node, parameters.names(node)).forEach((name, known) -> {
      if (!known.descriptor().readOnly() && !(PlainValues.of(known.value()) instanceof List<?>)) {
        all.add(tunable(name, known));
      }
    });
    return List.copyOf(all);
  }

  private static Tunable tunable(String name, NodeParameters.Known known) {
    Ros2ParameterDescriptor d = known.descriptor();
    Object value = PlainValues.of(known.value());
    int dot = name.lastIndexOf('.');
    String group = dot < 0 ? "" : name.substring(0, dot).replace('.', '/');
    String help =
        d.constraints().isBlank() ? d.description() : (d.description() + " (" + d.constraints() + ")").strip();
    Optional<Object> least = value instanceof Long ? d.integers().map(r -> r.from()) : d.doubles().map(r -> r.from());
    Optional<Object> most = value instanceof Long ? d.integers().map(r -> r.to()) : d.doubles().map(r -> r.to());
    boolean number = value instanceof Number;
    return new Tunable(name, group, help, value, value, number ? least : Optional.empty(),
        number ? most : Optional.empty(), List.of());
  }

  List<Tunable> change(Ros2Name node, Map<String, Object> values) throws CallException {
    Map<String, Ros2ParameterValue> changed = new LinkedHashMap<>();
    for (Map.Entry<String, Object> each : values.entrySet()) {
      changed.put(each.getKey(), changed(new Place(node, each.getKey()), each.getValue()));
    }
    parameters.set(node, changed);
    return tunables(node);
  }
}
