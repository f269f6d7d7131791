package org.robotui.rfic.ros2.internal.call;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.graph.GraphAction;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.graph.GraphService;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.graph.GraphTopic;
import org.robotui.ros2.name.Ros2Name;

/**
 * What a ROS 2 robot has, as its programs announce it. A parameter is named by its node and its own name, with a slash
 * between them. What tools do not list is left out.
 */
public final class Ros2Browser implements Browser {
  private final Ros2Node node;
  private final NodeSettings settings;
  private final Ros2Describer describer;

  /**
   * Creates a browser.
   *
   * @param node is in the graph
   * @param parameters asks nodes for theirs
   */
  public Ros2Browser(Ros2Node node, NodeParameters parameters) {
    this.node = node;
    this.settings = new NodeSettings(parameters);
    this.describer = new Ros2Describer(node);
  }

  private GraphState state() {
    return node.context().graph().state();
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    return switch (kind) {
      case TOPIC -> items(kind, state().topics(), GraphTopic::name,
          topic -> ends(topic).flatMap(end -> end.type().stream()).findFirst());
      case SERVICE -> items(kind, state().services(), GraphService::name, GraphService::type);
      case ACTION -> items(kind, state().actions(), GraphAction::name, GraphAction::type);
      case NODE -> named(kind, nodes(state()));
      case PARAMETER -> named(kind, settings.all());
      case TUNABLE -> named(kind, settings.nodes().stream().map(Ros2Name::text).toList());
    };
  }

  private static <T> List<Item> items(Kind kind, List<T> things, Function<T, Ros2Name> name,
      Function<T, Optional<TypeName>> type) {
    return things.stream().filter(thing -> !name.apply(thing).hidden())
        .map(thing -> new Item(kind, name.apply(thing).text(), type.apply(thing).map(TypeName::plain).orElse("")))
        .toList();
  }

  private static List<Item> named(Kind kind, List<String> names) {
    return names.stream().map(name -> new Item(kind, name, "")).toList();
  }

  /** Programs that know nothing of nodes, such as those of DDS alone, are listed as what they are called there. */
  private static List<String> nodes(GraphState state) {
    TreeSet<String> all = new TreeSet<>();
    state.nodes().stream().filter(each -> !each.name().hidden()).forEach(each -> all.add(each.name().text()));
    state.topics().stream().flatMap(Ros2Browser::ends).filter(end -> end.node().isEmpty())
        .forEach(end -> all.add(program(end)));
    return List.copyOf(all);
  }

  private static Stream<GraphEnd> ends(GraphTopic topic) {
    return Stream.concat(topic.publishers().stream(), topic.subscribers().stream());
  }

  private static String program(GraphEnd end) {
    return end.node().map(Ros2Name::text).orElseGet(() -> end.guid().participant().toString());
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case TOPIC -> describer.topic(item, state());
      case SERVICE -> describer.service(item, state());
      case ACTION -> describer.action(item, state());
      case NODE -> describer.program(item, state());
      case TUNABLE -> settings.describeNode(item);
      case PARAMETER -> settings.describe(item);
    };
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    return settings.value(name);
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    settings.set(name, value);
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    return settings.tunables(Ros2Services.name(item.name()));
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    return settings.change(Ros2Services.name(item.name()), values);
  }

  @Override
  public List<Link> links() {
    List<Link> all = new ArrayList<>();
    state().topics().stream().filter(topic -> !topic.name().hidden()).forEach(topic -> {
      topic.publishers().stream().map(Ros2Browser::program).distinct()
          .forEach(program -> all.add(new Link(program, topic.name().text(), true)));
      topic.subscribers().stream().map(Ros2Browser::program).distinct()
          .forEach(program -> all.add(new Link(program, topic.name().text(), false)));
    });
    return all;
  }
}
