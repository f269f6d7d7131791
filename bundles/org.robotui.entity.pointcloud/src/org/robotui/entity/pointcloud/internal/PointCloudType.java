package org.robotui.entity.pointcloud.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.sensor.PointCloud;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.shape.ColorRamp;

/** Shows point clouds. */
@Component(service = DisplayType.class)
public final class PointCloudType implements DisplayType {
  private static final Schema SCHEMA = Schema.of(
      Setting.of("color_by", new ValueType.Choice(List.of("auto", "axis", "field", "rgb", "flat")), "auto",
          "What colours points: a coordinate, a field, their own colours, or nothing; auto takes their own, else the intensity, else z."),
      Setting.of("axis", new ValueType.Choice(List.of("x", "y", "z")), "z", "The coordinate that colours."),
      Setting.of("axis_frame", new ValueType.Choice(List.of("fixed", "own")), "fixed",
          "Whether the coordinate is that in the fixed frame of the scene, or in the frame of the cloud."),
      Setting.of("field", new ValueType.Text(), "intensity", "The field that colours."),
      Setting.of("colors", new ValueType.Choice(ColorRamp.ids()), ColorRamp.TURBO.id(),
          "The colours from the least to the greatest value."),
      Setting.of("reverse", new ValueType.Flag(), false, "Whether the colours begin with their last."),
      Setting.optional("min", new ValueType.Num(-1e12, 1e12, ""),
          "The value of the first colour; without it, the least of each cloud."),
      Setting.optional("max", new ValueType.Num(-1e12, 1e12, ""),
          "The value of the last colour; without it, the greatest of each cloud."),
      ColorSetting.of("color", "#4cc2ff", "The colour of all points where nothing else colours them."),
      Setting.of("size", new ValueType.Num(0.0001, 100, ""), 2.0, "Edge or diameter of a point, in the unit."),
      Setting.of("unit", new ValueType.Choice(List.of("pixels", "metres")), "pixels", "What the size is in."),
      Setting.of("style", new ValueType.Choice(List.of("square", "disc")), "square", "How a point looks."),
      Setting.of("opacity", new ValueType.Num(0, 1, ""), 1.0, "0 invisible to 1 opaque."),
      Setting.of("decay", new ValueType.Num(0, 3600, "s"), 0.0, "How long a cloud stays; 0 shows the newest only."),
      Setting.of("most_points", new ValueType.Int(1000, CloudPoints.MOST), 5_000_000L,
          "Points at most; older clouds make room, and of a cloud that alone has more, an even part is shown."));

  @Override
  public String id() {
    return "pointcloud";
  }

  @Override
  public String label() {
    return "Point cloud";
  }

  @Override
  public String help() {
    return "Shows point clouds of lidars and depth cameras.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(PointCloud.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new PointCloudDisplay();
  }
}
