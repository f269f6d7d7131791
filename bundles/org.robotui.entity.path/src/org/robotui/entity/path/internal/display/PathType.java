package org.robotui.entity.path.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.navigation.Path;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows planned ways in space. */
@Component(service = DisplayType.class)
public final class PathType implements DisplayType {
  private static final Schema SCHEMA = Schema.of(
      ColorSetting.of("color", "#f5b83d", "The colour of the path."),
      Setting.of("width", new ValueType.Num(0.5, 50, "px"), 3.0, "Width of the line."),
      Setting.of("opacity", new ValueType.Num(0, 1, ""), 1.0, "0 invisible to 1 opaque."),
      Setting.of("height", new ValueType.Num(-1000, 1000, "m"), 0.01, "How far above its own place it is drawn."),
      Setting.of("poses", new ValueType.Choice(List.of("none", "axes", "arrows")), "none",
          "How the pose at each place is shown."),
      Setting.of("length", new ValueType.Num(0.001, 1000, "m"), 0.2, "Length of axes and arrows."));

  @Override
  public String id() {
    return "path";
  }

  @Override
  public String label() {
    return "Path";
  }

  @Override
  public String help() {
    return "Shows a path, such as the plan of a navigation stack.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Path.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new PathDisplay();
  }
}
