package org.robotui.uic.tftree.internal.model;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.robotui.api.frame.FrameLink;
import org.robotui.data.FrameId;

/**
 * The frames as trees. Built from what was held at one moment; where links were read while one moved, a frame that
 * would close a loop is a root.
 *
 * @param roots frames that nothing carries, sorted
 * @param links by the frame that is carried
 * @param children by the frame that carries, sorted
 * @param below how many frames lie below each, at any depth
 * @param size how many frames
 */
record Forest(List<FrameId> roots, Map<FrameId, FrameLink> links, Map<FrameId, List<FrameId>> children,
    Map<FrameId, Integer> below, int size) {
  static final Forest EMPTY = of(List.of(), List.of());

  private static final Comparator<FrameId> ORDER = Comparator.comparing(FrameId::robot).thenComparing(FrameId::name);

  static Forest of(List<FrameId> alone, List<FrameLink> links) {
    Map<FrameId, FrameLink> byChild = new HashMap<>();
    Map<FrameId, List<FrameId>> children = new HashMap<>();
    Set<FrameId> frames = new TreeSet<>(ORDER);
    frames.addAll(alone);
    for (FrameLink link : links) {
      if (byChild.put(link.child(), link) == null) {
        children.computeIfAbsent(link.parent(), parent -> new ArrayList<>()).add(link.child());
        frames.add(link.child());
        frames.add(link.parent());
      }
    }
    children.values().forEach(list -> list.sort(ORDER));
    List<FrameId> roots = new ArrayList<>(frames.stream().filter(frame -> !byChild.containsKey(frame)).toList());
    return new Forest(List.copyOf(roots), byChild, children, counts(roots, children), frames.size());
  }

  /** All frames, each after the one that carries it. */
  List<FrameId> inOrder() {
    return inOrder(roots, children);
  }

  private static List<FrameId> inOrder(List<FrameId> roots, Map<FrameId, List<FrameId>> children) {
    List<FrameId> order = new ArrayList<>();
    Set<FrameId> seen = new HashSet<>();
    Deque<FrameId> next = new ArrayDeque<>(roots);
    while (!next.isEmpty()) {
      FrameId frame = next.pop();
      if (seen.add(frame)) {
        order.add(frame);
        children.getOrDefault(frame, List.of()).reversed().forEach(next::push);
      }
    }
    return order;
  }

  private static Map<FrameId, Integer> counts(List<FrameId> roots, Map<FrameId, List<FrameId>> children) {
    Map<FrameId, Integer> below = new HashMap<>();
    List<FrameId> order = inOrder(roots, children);
    Collections.reverse(order);
    for (FrameId frame : order) {
      below.put(frame,
          children.getOrDefault(frame, List.of()).stream().mapToInt(child -> 1 + below.getOrDefault(child, 0)).sum());
    }
    return below;
  }

  List<FrameId> childrenOf(FrameId frame) {
    return children.getOrDefault(frame, List.of());
  }

  Optional<FrameId> parent(FrameId frame) {
    return Optional.ofNullable(links.get(frame)).map(FrameLink::parent);
  }

  /** The root of the tree that a frame is in. */
  FrameId root(FrameId frame) {
    FrameId at = frame;
    for (int i = 0; i < size && links.containsKey(at); i++) {
      at = links.get(at).parent();
    }
    return at;
  }

  boolean contains(FrameId frame) {
    return below.containsKey(frame);
  }

  /** The robots whose frames these are. */
  List<String> robots() {
    return below.keySet().stream().map(FrameId::robot).distinct().sorted().toList();
  }
}
