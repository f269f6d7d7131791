package org.robotui.uic.parameters.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Port;

/** The ports of the view. */
public final class ParametersPorts {
  public static final BrowsePort GRAPH = new BrowsePort("graph", Arity.MANY, "whose parameters are shown");

  private ParametersPorts() {}

  public static List<Port> all() {
    return List.of(GRAPH);
  }
}
