package org.robotui.entity.grid.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows the axes of a frame. */
@Component(service = DisplayType.class)
public final class AxesType implements DisplayType {
  private static final Schema SCHEMA = Schema.of(
      Setting.of("frame", new ValueType.Text(TextRule.FRAME.orEmpty("\"\"")), "",
          "The frame that is shown; without it, the fixed frame."),
      Setting.of("length", new ValueType.Num(0.001, 10_000, "m"), 0.5, "Length of the axes."),
      Setting.of("opacity", new ValueType.Num(0, 1, ""), 1.0, "0 invisible to 1 opaque."),
      Setting.of("label", new ValueType.Flag(), true, "Whether its name is written above it."),
      ColorSetting.of("label_color", "#9aa4b2", "The colour of the name."));

  @Override
  public String id() {
    return "axes";
  }

  @Override
  public String label() {
    return "Axes";
  }

  @Override
  public String help() {
    return "Shows where a frame is: x red, y green, z blue.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of();
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new AxesDisplay();
  }
}
