package org.robotui.uic.graph.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Settings;
import org.robotui.api.show.Showing;

/** Shows which node of a robot sends what to which. */
@Component(service = UicType.class)
public final class GraphType implements UicType {
  private static final double RATE_HZ = 10;

  private static final Descriptor DESCRIPTOR = new Descriptor("graph", "Graph",
      "The nodes of a robot and the topics between them, laid out, with rates where they are measured.",
      GraphOptions.schema(), GraphPorts.all());

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public List<Showing> showings() {
    return List.of(Showing.nodes("node", "Show in Graph"));
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new GraphUic(context);
  }
}
