package org.robotui.uic.graph.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.robotui.uic.graph.internal.model.Net.Edge;
import org.robotui.uic.graph.internal.model.Vertex.Kind;
import org.robotui.uic.graph.internal.model.Wiring.Tie;

/**
 * Makes the net of boxes and edges: topics as boxes or as edges, and namespaces closed to one box. A node of the name
 * of a namespace lies in it. Where there are more boxes than wanted, each namespace with several of them is closed
 * until it is opened, and so are many topics that are wired alike. Used once.
 */
final class Netting {
  private static final Comparator<Vertex> ORDER =
      Comparator.comparing(Vertex::robot).thenComparing(Vertex::name).thenComparing(Vertex::kind);
  private static final int SMALL = 8;

  private final Ask ask;
  private final int closeFrom;
  private final boolean robots;
  private final Alike alike;
  private final Set<Vertex> folds;
  private final Map<Vertex, List<Vertex>> paths = new HashMap<>();
  private final Map<Vertex, Integer> sizes = new HashMap<>();
  private final Set<Vertex> all = new TreeSet<>(ORDER);

  private Netting(List<Tie> ties, Ask ask, int closeFrom) {
    this.ask = ask;
    this.closeFrom = closeFrom;
    robots = ties.stream().map(tie -> tie.node().robot()).distinct().count() > 1;
    alike = ask.topics() ? Alike.of(ties) : new Alike(Map.of());
    folds = Set.copyOf(alike.groups().values());
    ties.forEach(tie -> {
      all.add(tie.node());
      if (ask.topics()) {
        all.add(tie.topic());
      }
    });
    Set<String> spaces = all.stream().map(Netting::space).collect(Collectors.toSet());
    all.forEach(vertex -> paths.put(vertex, path(vertex, spaces)));
    paths.values().forEach(path -> path.forEach(group -> sizes.merge(group, 1, Integer::sum)));
  }

  static Net of(List<Tie> sifted, Ask ask, int closeFrom) {
    return new Netting(sifted, ask, closeFrom).net(sifted);
  }

  private Net net(List<Tie> ties) {
    Map<Vertex, Vertex> shown = new HashMap<>();
    all.forEach(
        vertex -> shown.put(vertex, paths.get(vertex).stream().filter(this::closed).findFirst().orElse(vertex)));
    Map<List<Vertex>, Set<Vertex>> edges = ask.topics() ? throughTopics(ties, shown) : fromNodeToNode(ties, shown);
    Set<Vertex> vertices = new TreeSet<>(ORDER);
    vertices.addAll(shown.values());
    List<Edge> sorted =
        edges.entrySet().stream().map(e -> new Edge(e.getKey().get(0), e.getKey().get(1), Set.copyOf(e.getValue())))
            .sorted(Comparator.comparing(Edge::from, ORDER).thenComparing(Edge::to, ORDER)).toList();
    Map<Vertex, Vertex> within = ask.groups() ? frames(shown) : Map.of();
    Set<Vertex> frames = new TreeSet<>(ORDER);
    frames.addAll(within.values());
    return new Net(List.copyOf(vertices), sorted, List.copyOf(frames), Map.copyOf(within), Map.copyOf(sizes));
  }

  private static Map<List<Vertex>, Set<Vertex>> throughTopics(List<Tie> ties, Map<Vertex, Vertex> shown) {
    Map<List<Vertex>, Set<Vertex>> edges = new LinkedHashMap<>();
    for (Tie tie : ties) {
      Vertex node = shown.get(tie.node());
      Vertex topic = shown.get(tie.topic());
      if (!node.equals(topic)) {
        edges.computeIfAbsent(tie.sends() ? List.of(node, topic) : List.of(topic, node), e -> new HashSet<>())
            .add(tie.topic());
      }
    }
    return edges;
  }

  private static Map<List<Vertex>, Set<Vertex>> fromNodeToNode(List<Tie> ties, Map<Vertex, Vertex> shown) {
    Map<Vertex, Set<Vertex>> senders = new HashMap<>();
    ties.stream().filter(Tie::sends)
        .forEach(tie -> senders.computeIfAbsent(tie.topic(), t -> new HashSet<>()).add(shown.get(tie.node())));
    Map<List<Vertex>, Set<Vertex>> edges = new LinkedHashMap<>();
    ties.stream().filter(tie -> !tie.sends()).forEach(tie -> {
      Vertex to = shown.get(tie.node());
      senders.getOrDefault(tie.topic(), Set.of()).stream().filter(from -> !from.equals(to))
          .forEach(from -> edges.computeIfAbsent(List.of(from, to), e -> new HashSet<>()).add(tie.topic()));
    });
    return edges;
  }

  /** A frame is drawn around two boxes or more. */
  private Map<Vertex, Vertex> frames(Map<Vertex, Vertex> shown) {
    Map<Vertex, Vertex> within = new HashMap<>();
    Set<Vertex> drawn = new HashSet<>();
    shown.forEach((vertex, box) -> {
      List<Vertex> around = paths.get(vertex).stream().filter(group -> !closed(group) && sizes.get(group) > 1).toList();
      if (drawn.add(box)) {
        // A closed namespace lies in the frames above it, a vertex in all of its own.
        List<Vertex> frames = around.stream()
            .takeWhile(group -> box.kind() != Kind.GROUP || box.name().startsWith(group.name()) && !box.equals(group))
            .toList();
        for (int i = 0; i + 1 < frames.size(); i++) {
          within.put(frames.get(i + 1), frames.get(i));
        }
        if (!frames.isEmpty()) {
          within.put(box, frames.getLast());
        }
      }
    });
    return within;
  }

  private boolean closed(Vertex group) {
    boolean top = group.segments().size() == (robots ? 2 : 1) || group.name().isEmpty();
    boolean large = all.size() > closeFrom && sizes.get(group) > (top ? 1 : SMALL) && !group.name().isEmpty();
    return ask.closed().contains(group) || (large || folds.contains(group)) && !ask.opened().contains(group);
  }

  /** The namespaces in which it lies, the outermost first; where there are several robots, each is one. */
  private List<Vertex> path(Vertex vertex, Set<String> spaces) {
    List<Vertex> path = new ArrayList<>();
    if (robots) {
      path.add(new Vertex(Kind.GROUP, vertex.robot(), ""));
    }
    Optional<Vertex> fold = alike.groupOf(vertex);
    if (fold.isPresent()) {
      path.add(fold.get());
      return path;
    }
    String space = vertex.kind() == Kind.NODE && spaces.contains(vertex.name()) ? vertex.name() : space(vertex);
    for (int at = space.indexOf('/', 1); !space.isEmpty(); at = space.indexOf('/', at + 1)) {
      path.add(new Vertex(Kind.GROUP, vertex.robot(), at < 0 ? space : space.substring(0, at)));
      if (at < 0) {
        break;
      }
    }
    return path;
  }

  private static String space(Vertex vertex) {
    return Optional.of(vertex.name()).map(name -> name.substring(0, Math.max(0, name.lastIndexOf('/')))).orElse("");
  }
}
