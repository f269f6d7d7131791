package org.robotui.entity.laserscan.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.sensor.LaserScan;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.shape.ColorRamp;

/** Shows laser scans in space. */
@Component(service = DisplayType.class)
public final class LaserScanType implements DisplayType {
  private static final Schema SCHEMA = Schema.of(
      Setting.of("color_by", new ValueType.Choice(List.of("flat", "range", "intensity")), "flat",
          "What colours echoes."),
      ColorSetting.of("color", "#ff6b5e", "The colour of all echoes where nothing else colours them, and of lines."),
      Setting.of("colors", new ValueType.Choice(ColorRamp.ids()), ColorRamp.TURBO.id(),
          "The colours from the least to the greatest value."),
      Setting.optional("min", new ValueType.Num(-1e12, 1e12, ""),
          "The value of the first colour; without it, the least of each scan."),
      Setting.optional("max", new ValueType.Num(-1e12, 1e12, ""),
          "The value of the last colour; without it, the greatest of each scan."),
      Setting.of("style", new ValueType.Choice(List.of("points", "lines", "both")), "points",
          "Whether echoes are points, or neighbours are joined by lines."),
      Setting.of("gap", new ValueType.Num(0, 1000, "m"), 0.3, "Neighbours farther apart than this are not joined."),
      Setting.of("size", new ValueType.Num(0.0001, 100, ""), 4.0, "Edge of a point, in the unit."),
      Setting.of("unit", new ValueType.Choice(List.of("pixels", "metres")), "pixels", "What the size is in."),
      Setting.of("opacity", new ValueType.Num(0, 1, ""), 1.0, "0 invisible to 1 opaque."),
      Setting.of("decay", new ValueType.Num(0, 3600, "s"), 0.0, "How long a scan stays; 0 shows the newest only."));

  @Override
  public String id() {
    return "laserscan";
  }

  @Override
  public String label() {
    return "Laser scan";
  }

  @Override
  public String help() {
    return "Shows laser scans.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(LaserScan.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new LaserScanDisplay();
  }
}
