package org.robotui.uic.diagnostics.internal.model;

import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.port.SourceId;
import org.robotui.data.status.Diagnostics;

/** The trees of names, one a source, bounded. One thread. */
final class Forest {
  static final int MOST_PARTS = 5000;

  private static final int LONGEST_NAME = 512;
  private static final int DEEPEST = 12;

  /** What one source says. */
  static final class Tree {
    private final Node root;
    private final Map<String, Part> parts = new HashMap<>();

    Tree(Node root) {
      this.root = root;
    }

    Node root() {
      return root;
    }

    int size() {
      return parts.size();
    }

    /** Whether all names are paths from a root, as those of who sorts the reports of others. */
    boolean sorted() {
      return !parts.isEmpty() && parts.keySet().stream().allMatch(name -> name.startsWith("/"));
    }

    boolean alive(long now, long staleNanos) {
      return parts.values().stream().anyMatch(part -> !part.silent(now, staleNanos));
    }
  }

  private final Map<SourceId, Tree> trees = new LinkedHashMap<>();
  private final History history;
  private final int slots;
  private long refused;

  Forest(History history, int slots) {
    this.history = history;
    this.slots = slots;
  }

  void take(SourceId source, Diagnostics.Item item, long nanos) {
    Tree tree = trees.computeIfAbsent(source, s -> new Tree(new Node(s.toString(), s.port(), slots)));
    String name = item.name().length() <= LONGEST_NAME ? item.name() : item.name().substring(0, LONGEST_NAME);
    if (!tree.parts.containsKey(name) && size() >= MOST_PARTS) {
      refused++;
      return;
    }
    history.note(tree.parts.computeIfAbsent(name, n -> plant(tree.root, n)), item, nanos);
  }

  Map<SourceId, Tree> trees() {
    return trees;
  }

  int size() {
    return trees.values().stream().mapToInt(Tree::size).sum();
  }

  /** Reports of parts beyond the bound. */
  long refused() {
    return refused;
  }

  /** Forgets the parts that have said nothing for too long. */
  void forgetSilent(long now, long staleNanos) {
    for (Tree tree : trees.values()) {
      tree.parts.values().stream().filter(part -> part.silent(now, staleNanos)).toList().forEach(part -> {
        tree.parts.remove(part.name());
        history.forget(part);
      });
      tree.root.prune(part -> !tree.parts.containsKey(part.name()));
    }
    trees.values().removeIf(tree -> tree.size() == 0);
    refused = 0;
  }

  private Part plant(Node root, String name) {
    Part part = new Part(name);
    Node node = root;
    for (String step : path(name)) {
      node = node.child(step, slots);
    }
    // Two names may mean the same place ("a/b" and "/a/b"): each keeps a line of its own.
    while (node.part().isPresent()) {
      node = node.child(name, slots);
    }
    node.part(part);
    return part;
  }

  /** The steps to a name; one without any is its own. */
  static List<String> path(String name) {
    List<String> steps = Arrays.stream(name.split("/")).map(String::strip).filter(step -> !step.isEmpty()).toList();
    if (steps.isEmpty()) {
      return List.of(name.isBlank() ? "(no name)" : name);
    }
    if (steps.size() <= DEEPEST) {
      return steps;
    }
    List<String> cut = new java.util.ArrayList<>(steps.subList(0, DEEPEST - 1));
    cut.add(String.join("/", steps.subList(DEEPEST - 1, steps.size())));
    return cut;
  }
}
