package org.robotui.uic.map.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Port;

/** The map: what robots know of the floor around them, seen from above. */
@Component(service = UicType.class)
public final class MapType implements UicType {
  private static final double RATE_HZ = 30;

  private final Schema schema = MapOptions.schema();

  @Override
  public String id() {
    return "map";
  }

  @Override
  public String label() {
    return "Map";
  }

  @Override
  public String help() {
    return "Grid maps, scans, sonars, ways and robots from above; measures, and sends goals and initial poses.";
  }

  @Override
  public Schema schema() {
    return schema;
  }

  @Override
  public List<Port> ports() {
    return MapPorts.ALL;
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
  public Uic create(UicContext context, Settings settings) {
    return new MapUic(context);
  }
}
