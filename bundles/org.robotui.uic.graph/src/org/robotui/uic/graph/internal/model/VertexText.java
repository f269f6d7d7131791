package org.robotui.uic.graph.internal.model;

import java.util.Map;
import java.util.Optional;
import org.robotui.ui.Figures;
import org.robotui.ui.ask.Measure;
import org.robotui.uic.graph.internal.model.Vertex.Kind;
import org.robotui.uic.graph.internal.model.Wiring.Tie;

/** All about a vertex, in a line. Pure. */
final class VertexText {
  private static final String DOT = "  \u00b7  ";

  private VertexText() {}

  static String of(Vertex vertex, Wiring wiring, Map<Vertex, Measure> measures) {
    return switch (vertex.kind()) {
      case NODE -> vertex.name() + DOT + "sends " + count(wiring, vertex, true) + DOT + "takes "
          + count(wiring, vertex, false);
      case TOPIC -> topic(vertex, wiring)
          + Optional.ofNullable(measures.get(vertex)).map(VertexText::measured).orElse("");
      case GROUP -> vertex.name().isEmpty() ? vertex.robot() : vertex.name();
    };
  }

  private static String topic(Vertex topic, Wiring wiring) {
    String type = wiring.types().getOrDefault(topic, "");
    return topic.name() + (type.isEmpty() ? "" : DOT + type) + DOT + "sent by " + count(wiring, topic, true) + DOT
        + "taken by "
        + count(wiring, topic, false) + (wiring.stream(topic).isPresent() ? "" : DOT + "no stream to measure");
  }

  private static String measured(Measure measure) {
    return DOT + (measure.count() == 0 ? "no message yet" : Figures.rate(measure.hertz()))
        + (measure.bytesPerSecond().isPresent() && measure.bytesPerSecond().getAsDouble() > 0
            ? DOT + Labels.bandwidth(measure.bytesPerSecond().getAsDouble())
            : "");
  }

  private static long count(Wiring wiring, Vertex vertex, boolean sends) {
    return wiring.ties().stream().filter(tie -> tie.sends() == sends && end(tie, vertex.kind()).equals(vertex)).count();
  }

  private static Vertex end(Tie tie, Kind kind) {
    return kind == Kind.NODE ? tie.node() : tie.topic();
  }
}
