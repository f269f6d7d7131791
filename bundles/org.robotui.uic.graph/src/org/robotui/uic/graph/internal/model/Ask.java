package org.robotui.uic.graph.internal.model;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * What is asked for.
 *
 * @param words all of which must be in the name of a node or topic, in lower case; what is wired to it is shown as well
 * @param topics whether topics have boxes, else they are wires
 * @param tools whether tools and their topics are left out
 * @param tf whether transforms are left out
 * @param ends whether topics that nobody sends or nobody takes are left out
 * @param groups whether namespaces are framed
 * @param opened namespaces that the user opened
 * @param closed namespaces that the user closed
 * @param selected a node, topic or namespace
 * @param measuring whether the selected topic, or those of the selected node, are measured
 */
public record Ask(
    List<String> words,
    boolean topics,
    boolean tools,
    boolean tf,
    boolean ends,
    boolean groups,
    Set<Vertex> opened,
    Set<Vertex> closed,
    Optional<Vertex> selected,
    boolean measuring) {
  /** At first. */
  public static final Ask FIRST =
      new Ask(List.of(), true, true, true, true, true, Set.of(), Set.of(), Optional.empty(), false);

  /** Copies the collections. */
  public Ask {
    words = List.copyOf(words);
    opened = Set.copyOf(opened);
    closed = Set.copyOf(closed);
  }

  /** What is left out, and how the rest is shown. */
  public Ask show(boolean withTopics, boolean withoutTools, boolean withoutTf, boolean withoutEnds, boolean framed) {
    return new Ask(words, withTopics, withoutTools, withoutTf, withoutEnds, framed, opened, closed, selected,
        measuring);
  }

  /** With other words. */
  public Ask search(String typed) {
    List<String> next =
        Stream.of(typed.toLowerCase(Locale.ROOT).split("\\s+")).filter(word -> !word.isEmpty()).toList();
    return new Ask(next, topics, tools, tf, ends, groups, opened, closed, selected, measuring);
  }

  /** With a namespace opened or closed by the user. */
  public Ask open(Vertex group, boolean open) {
    Set<Vertex> nowOpened = new HashSet<>(opened);
    Set<Vertex> nowClosed = new HashSet<>(closed);
    (open ? nowOpened : nowClosed).add(group);
    (open ? nowClosed : nowOpened).remove(group);
    return new Ask(words, topics, tools, tf, ends, groups, nowOpened, nowClosed, selected, measuring);
  }

  /** With something else selected. */
  public Ask select(Optional<Vertex> vertex) {
    return new Ask(words, topics, tools, tf, ends, groups, opened, closed, vertex, measuring);
  }

  /** With measuring or without. */
  public Ask measure(boolean on) {
    return new Ask(words, topics, tools, tf, ends, groups, opened, closed, selected, on);
  }

  /** Whether another ask shows the same net, whatever is selected or measured. */
  boolean sameNet(Ask other) {
    return select(Optional.empty()).measure(false).equals(other.select(Optional.empty()).measure(false));
  }
}
