package org.robotui.entity.sonar.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows cones of sonars in space. */
@Component(service = DisplayType.class)
public final class SonarType implements DisplayType {
  private static final Schema SCHEMA = Schema.of(
      ColorSetting.of("color", "#9573dc", "The colour of cones; by itself that of the map."),
      Setting.of("opacity", new ValueType.Num(0, 1, ""), 0.14,
          "0 invisible to 1 opaque; a cone without an echo is fainter."),
      Setting.of("free", new ValueType.Flag(), true,
          "Whether cones without an echo are shown, to the limit of the sensor."));

  @Override
  public String id() {
    return "sonar";
  }

  @Override
  public String label() {
    return "Sonar";
  }

  @Override
  public String help() {
    return "Shows how far sonars and infrared sensors see.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(RangeReadings.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new SonarDisplay();
  }
}
