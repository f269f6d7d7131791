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

/** Shows a grid of lines. */
@Component(service = DisplayType.class)
public final class GridType implements DisplayType {
  private static final ValueType PLACE = new ValueType.Num(-1e6, 1e6, "m");

  private static final Schema SCHEMA = Schema.of(
      Setting.of("frame", new ValueType.Text(TextRule.FRAME.orEmpty("\"\"")), "",
          "The frame that it lies in; without it, the fixed frame."),
      Setting.of("plane", new ValueType.Choice(List.of("xy", "xz", "yz")), "xy", "The plane that it lies in."),
      Setting.of("cells", new ValueType.Int(1, 1000), 20L, "Cells along each edge."),
      Setting.of("cell", new ValueType.Num(0.001, 100_000, "m"), 1.0, "Edge of a cell."),
      ColorSetting.of("color", "#8b95a166", "The colour of its lines."),
      Setting.of("width", new ValueType.Num(0.5, 20, "px"), 1.0, "Width of its lines."),
      Setting.of("x", PLACE, 0.0, "Its middle in the frame."),
      Setting.of("y", PLACE, 0.0, "Its middle in the frame."),
      Setting.of("z", PLACE, 0.0, "Its middle in the frame."));

  @Override
  public String id() {
    return "grid";
  }

  @Override
  public String label() {
    return "Grid";
  }

  @Override
  public String help() {
    return "Shows a metric grid, by which distances are seen.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of();
  }

  @Override
  public boolean automatic() {
    return true;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new GridDisplay();
  }
}
