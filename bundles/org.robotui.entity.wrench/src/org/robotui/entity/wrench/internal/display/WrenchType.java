package org.robotui.entity.wrench.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.geometry.Wrench;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows forces and torques. */
@Component(service = DisplayType.class)
public final class WrenchType implements DisplayType {
  static final String FORCE_SCALE = "force_scale";
  static final String TORQUE_SCALE = "torque_scale";
  static final String WIDTH = "width";
  static final String LONGEST = "longest";
  static final String FORCE_COLOR = "force_color";
  static final String TORQUE_COLOR = "torque_color";

  static final Schema SCHEMA = Schema.of(
      Setting.of(FORCE_SCALE, new ValueType.Num(0, 1000, "m/N"), 0.02,
          "How long the arrow of one newton is; 0 for no arrow."),
      Setting.of(TORQUE_SCALE, new ValueType.Num(0, 1000, "m/Nm"), 0.1,
          "How long the arrow of one newton metre is; 0 for no arrow."),
      Setting.of(WIDTH, new ValueType.Num(0.0005, 1, "m"), 0.02, "How thick the arrows are."),
      Setting.of(LONGEST, new ValueType.Num(0.01, 1000, "m"), 3.0,
          "How long an arrow may be; a longer one is cut, and the display says so."),
      ColorSetting.of(FORCE_COLOR, "#e5484d", "Colour of the force."),
      ColorSetting.of(TORQUE_COLOR, "#e2a336", "Colour of the torque."));

  @Override
  public String id() {
    return "wrench";
  }

  @Override
  public String label() {
    return "Force and torque";
  }

  @Override
  public String help() {
    return "Shows what a force-torque sensor measures: an arrow along the force, and one along the axis of the torque with a ring that turns with it.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Wrench.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new WrenchDisplay();
  }
}
