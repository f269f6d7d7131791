package org.robotui.entity.speed.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.navigation.Odometry;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/**
 * The kind that scenes offer to users: what it is called, what can be set, which data it draws, and how an instance is
 * made.
 */
@Component(service = DisplayType.class)
public final class SpeedType implements DisplayType {

  static final String SCALE = "scale";

  static final String COLOR = "color";

  private static final Schema SCHEMA = Schema.of(
      Setting.of(SCALE, new ValueType.Num(0.01, 100, "s"), 1.0,
          "How long the arrow is: as far as the robot goes in this time."),
      ColorSetting.of(COLOR, "#2f9e6e", "Colour of the arrow."));

  @Override
  public String id() {
    return "speed";
  }

  @Override
  public String label() {
    return "Speed";
  }

  @Override
  public String help() {
    return "Shows an arrow where a robot is, in the direction in which it goes and as long as it is fast.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Odometry.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new SpeedDisplay();
  }
}
