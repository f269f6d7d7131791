package org.robotui.entity.marker.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.marker.MarkerSet;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows markers. */
@Component(service = DisplayType.class)
public final class MarkersType implements DisplayType {
  static final String NAMESPACES = "namespaces";
  static final String HIDDEN = "hidden_namespaces";
  static final String OPACITY = "opacity";
  static final String PACKAGES = "packages";

  private static final ValueType NAMES = new ValueType.ListOf(new ValueType.Text());
  static final Schema SCHEMA = Schema.of(
      Setting.of(NAMESPACES, NAMES, List.of(), "The namespaces whose markers are shown; empty for all."),
      Setting.of(HIDDEN, NAMES, List.of(), "Namespaces whose markers are not shown."),
      Setting.of(OPACITY, new ValueType.Num(0, 1, ""), 1.0, "0 invisible to 1 as the robot says."),
      Setting.of(PACKAGES, NAMES, List.of(),
          "Folders in which the packages of meshes are looked for; empty for those of ROS_PACKAGE_PATH."));

  @Override
  public String id() {
    return "markers";
  }

  @Override
  public String label() {
    return "Markers";
  }

  @Override
  public String help() {
    return "Shows what programs of the robot draw: arrows, solids, lines, points, texts, triangles and meshes.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(MarkerSet.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new MarkersDisplay(context);
  }
}
