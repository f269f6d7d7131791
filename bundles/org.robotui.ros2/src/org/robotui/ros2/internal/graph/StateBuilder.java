package org.robotui.ros2.internal.graph;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.graph.GraphAction;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.graph.GraphNode;
import org.robotui.ros2.graph.GraphService;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.graph.GraphTopic;
import org.robotui.ros2.name.DdsName;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.EndpointKind;

/** Sorts ends into topics, services and actions. */
final class StateBuilder {

  private static final String ACTION = "/_action/";

  /** The two sides of one topic of DDS. */
  private record Sides(List<GraphEnd> writers, List<GraphEnd> readers) {
    Sides() {
      this(new ArrayList<>(), new ArrayList<>());
    }
  }

  private final Map<DdsName.Role, Map<Ros2Name, Sides>> found = new TreeMap<>();

  void add(KnownEnds.End end, Optional<Ros2Name> node, boolean own) {
    Sides sides = found.computeIfAbsent(end.dds().role(), role -> new TreeMap<>())
        .computeIfAbsent(end.dds().name(), name -> new Sides());
    (end.info().kind() == EndpointKind.WRITER ? sides.writers() : sides.readers()).add(end.at(node, own));
  }

  GraphState state(List<GraphNode> nodes) {
    List<GraphNode> sorted = nodes.stream().sorted(Comparator.comparing(GraphNode::name)).toList();
    return new GraphState(sorted, topics(), services(), actions());
  }

  private Map<Ros2Name, Sides> of(DdsName.Role role) {
    return found.getOrDefault(role, Map.of());
  }

  private static boolean ofAction(Ros2Name name) {
    return name.text().contains(ACTION);
  }

  private List<GraphTopic> topics() {
    return of(DdsName.Role.TOPIC).entrySet().stream().filter(each -> !ofAction(each.getKey()))
        .map(each -> new GraphTopic(each.getKey(), each.getValue().writers(), each.getValue().readers())).toList();
  }

  private List<GraphService> services() {
    return of(DdsName.Role.REQUEST).entrySet().stream().filter(each -> !ofAction(each.getKey()))
        .map(each -> new GraphService(each.getKey(), each.getValue().readers(), each.getValue().writers())).toList();
  }

  /** A server takes goals; a client that only watches has feedback and status. */
  private List<GraphAction> actions() {
    return Stream.concat(of(DdsName.Role.REQUEST).keySet().stream(), of(DdsName.Role.TOPIC).keySet().stream())
        .filter(StateBuilder::ofAction).map(StateBuilder::nameOf).distinct().sorted().map(this::action).toList();
  }

  private static Ros2Name nameOf(Ros2Name part) {
    return Ros2Name.of(part.text().substring(0, part.text().lastIndexOf(ACTION)));
  }

  private GraphAction action(Ros2Name name) {
    Sides goals = of(DdsName.Role.REQUEST).getOrDefault(part(name, "send_goal"), new Sides());
    Sides feedback = of(DdsName.Role.TOPIC).getOrDefault(part(name, "feedback"), new Sides());
    Optional<TypeName> type = Stream.of(goals.readers(), goals.writers(), feedback.writers(), feedback.readers())
        .flatMap(List::stream).flatMap(end -> end.type().stream()).flatMap(part -> whole(part).stream()).findFirst();
    return new GraphAction(name, type, goals.readers(), goals.writers());
  }

  private static Ros2Name part(Ros2Name action, String name) {
    return Ros2Name.of(action.text() + ACTION + name);
  }

  private static Optional<TypeName> whole(TypeName part) {
    return part.whole("Request").flatMap(service -> service.whole("SendGoal"))
        .or(() -> part.whole("FeedbackMessage"));
  }
}
