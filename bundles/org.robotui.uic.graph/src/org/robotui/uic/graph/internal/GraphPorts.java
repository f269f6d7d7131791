package org.robotui.uic.graph.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Intake;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;

/** The ports of the view. */
public final class GraphPorts {
  public static final BrowsePort GRAPH =
      new BrowsePort("graph", Arity.MANY, "what the robot has, and how it is connected");

  public static final StreamPort<Data> ALL =
      new StreamPort<>("all", Data.class, Arity.MANY, "what is measured", Intake.CHOSEN);

  private GraphPorts() {}

  /** All of them. */
  public static List<Port> all() {
    return List.of(GRAPH, ALL);
  }
}
