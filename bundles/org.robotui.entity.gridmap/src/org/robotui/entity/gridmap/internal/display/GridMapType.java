package org.robotui.entity.gridmap.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.navigation.GridMap;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows grid maps in space. */
@Component(service = DisplayType.class)
public final class GridMapType implements DisplayType {
  private static final Schema SCHEMA = Schema.of(
      Setting.of("scheme", new ValueType.Choice(List.of("map", "costmap", "raw")), "map",
          "The colours of cells: free faint grey and occupied blue; costs from blue to red, 99 cyan, 100 magenta; or the bare numbers as greys."),
      Setting.of("opacity", new ValueType.Num(0, 1, ""), 0.8, "0 invisible to 1 opaque."),
      Setting.of("unknown", new ValueType.Flag(), false, "Whether cells of which nothing is known are painted."),
      Setting.of("height", new ValueType.Num(-1000, 1000, "m"), -0.01,
          "How far above its own plane it is drawn; a hair below, so that what lies on the ground is seen."));

  @Override
  public String id() {
    return "gridmap";
  }

  @Override
  public String label() {
    return "Grid map";
  }

  @Override
  public String help() {
    return "Shows maps and costmaps.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(GridMap.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new GridMapDisplay();
  }
}
