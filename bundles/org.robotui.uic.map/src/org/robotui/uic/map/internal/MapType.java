package org.robotui.uic.map.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Settings;
import org.robotui.api.show.Showing;

/** The map: what robots know of the floor around them, seen from above. */
@Component(service = UicType.class)
public final class MapType implements UicType {
  private static final double RATE_HZ = 30;

  private static final Descriptor DESCRIPTOR = new Descriptor("map", "Map",
      "Grid maps, scans, sonars, bumpers, paths and robots from above; measures, and sends goals and initial poses.",
      MapOptions.schema(), MapPorts.ALL);

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
    return List.of(Showing.streams("map", "Show in Map", MapPorts.SHOWN));
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new MapUic(context);
  }
}
