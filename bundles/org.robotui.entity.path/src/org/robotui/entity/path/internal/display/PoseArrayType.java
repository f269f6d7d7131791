package org.robotui.entity.path.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.geometry.PoseArray;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows many poses at once: particles of a localisation, grasps. */
@Component(service = DisplayType.class)
public final class PoseArrayType implements DisplayType {
  private static final Schema SCHEMA = Schema.of(
      ColorSetting.of("color", "#e5589b", "The colour of arrows."),
      Setting.of("opacity", new ValueType.Num(0, 1, ""), 0.8, "0 invisible to 1 opaque."),
      Setting.of("poses", new ValueType.Choice(List.of("arrows", "axes")), "arrows", "How each pose is shown."),
      Setting.of("length", new ValueType.Num(0.001, 1000, "m"), 0.2, "Length of arrows and axes."));

  @Override
  public String id() {
    return "poses";
  }

  @Override
  public String label() {
    return "Pose array";
  }

  @Override
  public String help() {
    return "Shows many poses: particles of a localisation, grasps.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(PoseArray.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new PoseArrayDisplay();
  }
}
