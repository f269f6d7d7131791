package org.robotui.uic.graph.internal.model;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.robotui.ui.Figures;
import org.robotui.ui.ask.Measure;
import org.robotui.ui.diagram.Diagram;
import org.robotui.ui.diagram.Wire;
import org.robotui.uic.graph.internal.model.Net.Edge;
import org.robotui.uic.graph.internal.model.Vertex.Kind;

/** What is written on wires: topics where they have no boxes, and rates where they are measured. Pure. */
final class Labels {
  private static final double KILO = 1e3;
  private static final double MEGA = 1e6;

  private Labels() {}

  /** Without measures: the topic where it has no box, or how many there are. */
  static String plain(Edge edge) {
    boolean boxed = edge.from().kind() == Kind.TOPIC || edge.to().kind() == Kind.TOPIC;
    return boxed ? ""
        : edge.topics().size() == 1 ? edge.topics().iterator().next().name() : edge.topics().size() + " topics";
  }

  /** The diagram with what is measured now. */
  static Diagram with(Diagram diagram, Net net, Map<Vertex, Measure> measures) {
    if (measures.isEmpty() || diagram.wires().size() > net.edges().size()) {
      return diagram;
    }
    Map<List<Vertex>, Set<Vertex>> topics = new HashMap<>();
    net.edges().forEach(edge -> topics.put(List.of(edge.from(), edge.to()), edge.topics()));
    List<Wire> wires = diagram.wires().stream().map(wire -> {
      String measured =
          words(topics.getOrDefault(List.of((Vertex) wire.from(), (Vertex) wire.to()), Set.of()), measures);
      String label =
          measured.isEmpty() ? wire.label() : wire.label().isEmpty() ? measured : wire.label() + "  " + measured;
      return wire.labelled(label);
    }).toList();
    return new Diagram(diagram.boxes(), wires, diagram.width(), diagram.height());
  }

  private static String words(Set<Vertex> topics, Map<Vertex, Measure> measures) {
    List<Measure> known = topics.stream().filter(measures::containsKey).map(measures::get).toList();
    if (known.isEmpty()) {
      return "";
    }
    double hertz = known.stream().mapToDouble(Measure::hertz).filter(h -> !Double.isNaN(h)).sum();
    double bytes = known.stream().mapToDouble(m -> m.bytesPerSecond().orElse(0)).filter(b -> !Double.isNaN(b)).sum();
    return Figures.rate(hertz) + (bytes > 0 ? " \u00b7 " + bandwidth(bytes) : "");
  }

  static String bandwidth(double bytes) {
    return bytes >= MEGA ? Figures.of(bytes / MEGA, 1, "MB/s")
        : bytes >= KILO ? Figures.of(bytes / KILO, 1, "kB/s") : Figures.of(bytes, 0, "B/s");
  }
}
