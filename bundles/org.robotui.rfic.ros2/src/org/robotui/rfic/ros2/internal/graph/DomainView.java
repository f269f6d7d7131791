package org.robotui.rfic.ros2.internal.graph;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.message.topic.TopicGraph;
import org.robotui.rfic.ros2.internal.Ros2Settings;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.graph.GraphTopic;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;

/** What others, beside this process, have in a domain at one moment. */
final class DomainView {
  /** What every node has, and what tools have as well. */
  private static final Set<String> COMMON = Set.of("/rosout", "/parameter_events", "/tf", "/tf_static", "/clock");

  private final GraphState state;
  private final String namespace;
  private final Pattern workbench;
  private final Predicate<Guid> ours;

  DomainView(GraphState state, Ros2Settings settings, Predicate<Guid> ours) {
    this.state = state;
    this.namespace = settings.topics().namespace();
    this.workbench = Pattern.compile(Pattern.quote(settings.node()) + "_\\d+_\\d+");
    this.ours = ours;
  }

  /** Who publishes and subscribes what. Names that tools do not list, such as those of their own, are left out. */
  TopicGraph topics() {
    return new TopicGraph(typed(GraphTopic::publishers), typed(GraphTopic::subscribers));
  }

  private Map<String, String> typed(Function<GraphTopic, List<GraphEnd>> side) {
    Map<String, String> types = new TreeMap<>();
    state.topics().stream().filter(topic -> !topic.name().hidden())
        .forEach(topic -> side.apply(topic).stream().filter(this::isForeign).flatMap(end -> end.type().stream())
            .findFirst().ifPresent(type -> types.put(topic.name().text(), type.plain())));
    return types;
  }

  private boolean isForeign(GraphEnd end) {
    return !end.own() && !ours.test(end.guid());
  }

  /** The participants that the robot consists of; none where it is away. */
  Set<GuidPrefix> robot() {
    Stream<GuidPrefix> ends = state.topics().stream().filter(topic -> belongs(topic.name()))
        .flatMap(topic -> Stream.concat(topic.publishers().stream(), topic.subscribers().stream()))
        .filter(end -> isForeign(end) && end.node().filter(this::isTool).isEmpty()).map(end -> end.guid().prefix());
    Stream<GuidPrefix> nodes = state.nodes().stream()
        .filter(node -> !node.own() && !ours.test(node.participant()) && belongs(node.name()) && !isTool(node.name()))
        .map(node -> node.participant().prefix());
    return Stream.concat(ends, nodes).collect(Collectors.toUnmodifiableSet());
  }

  private boolean belongs(Ros2Name name) {
    return (name.text() + "/").startsWith(namespace) && !COMMON.contains(name.text()) && !name.hidden();
  }

  /** Other workbenches, and tools, are no robots. */
  private boolean isTool(Ros2Name node) {
    return node.hidden() || workbench.matcher(node.base()).matches();
  }

  /** The first parts of the names of topics in namespaces. */
  Set<String> namespaces() {
    return state.topics().stream().map(topic -> topic.name().text()).filter(name -> name.indexOf('/', 1) > 1)
        .map(name -> name.substring(1, name.indexOf('/', 1))).collect(Collectors.toUnmodifiableSet());
  }

  /** The type of a topic that others publish. */
  Optional<String> published(String topic) {
    return Ros2Name.parse(topic).flatMap(state::topic).stream().flatMap(t -> t.publishers().stream())
        .filter(this::isForeign).flatMap(end -> end.type().stream()).findFirst().map(type -> type.plain());
  }
}
