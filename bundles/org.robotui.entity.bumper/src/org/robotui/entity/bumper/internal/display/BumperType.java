package org.robotui.entity.bumper.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.sensor.Bumpers;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows bumpers in space. */
@Component(service = DisplayType.class)
public final class BumperType implements DisplayType {
  static final String COLOR = "color";
  static final String PRESSED_COLOR = "pressed_color";
  static final String HEIGHT = "height";

  private static final Schema SCHEMA = Schema.of(
      ColorSetting.of(COLOR, "#8b95a1", "The colour of bumpers that are free."),
      ColorSetting.of(PRESSED_COLOR, "#e5484d", "The colour of bumpers that are pressed."),
      Setting.of(HEIGHT, new ValueType.Num(0.001, 10, "m"), 0.04, "From their lower to their upper edge."));

  @Override
  public String id() {
    return "bumper";
  }

  @Override
  public String label() {
    return "Bumpers";
  }

  @Override
  public String help() {
    return "Shows the bumpers around a robot, and which are pressed.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Bumpers.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new BumperDisplay();
  }
}
