package org.robotui.uic.diagnostics.internal.model;

import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.ui.control.NaturalOrder;

/** A place in the tree of names: a group, a part, or both. One thread. */
final class Node {
  private final String key;
  private final String label;
  private final Timeline timeline;
  private final Map<String, Node> children = new TreeMap<>(NaturalOrder.ORDER);
  private Optional<Part> part = Optional.empty();
  private Level level = Level.UNKNOWN;

  Node(String key, String label, int slots) {
    this.key = key;
    this.label = label;
    this.timeline = new Timeline(slots);
  }

  String key() {
    return key;
  }

  String label() {
    return label;
  }

  Timeline timeline() {
    return timeline;
  }

  Collection<Node> children() {
    return children.values();
  }

  Node child(String name, int slots) {
    return children.computeIfAbsent(name, n -> new Node(key + "/" + n, n, slots));
  }

  Optional<Part> part() {
    return part;
  }

  void part(Part next) {
    part = Optional.of(next);
  }

  /** How it is now: the worst of itself and all below. */
  Level level() {
    return level;
  }

  /** Takes the levels of the parts up to the groups, notes them, and counts those that changed. */
  Level bubble(long now, long staleNanos, long slot, int[] changes) {
    Level worst = part.map(p -> p.level(now, staleNanos)).orElse(Level.UNKNOWN);
    for (Node child : children.values()) {
      worst = worst.worse(child.bubble(now, staleNanos, slot, changes));
    }
    changes[0] += level == worst ? 0 : 1;
    level = worst;
    timeline.mark(slot, worst);
    return worst;
  }

  /** Takes away the parts that a condition names, and the groups that are left empty. */
  boolean prune(java.util.function.Predicate<Part> gone) {
    children.values().removeIf(child -> child.prune(gone));
    part = part.filter(gone.negate());
    return children.isEmpty() && part.isEmpty();
  }
}
