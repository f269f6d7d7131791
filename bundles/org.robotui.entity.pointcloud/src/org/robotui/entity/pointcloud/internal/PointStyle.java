package org.robotui.entity.pointcloud.internal;

import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.sensor.PointCloud;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.shape.ColorRamp;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Rgba;

/**
 * The settings that shapes are made by.
 *
 * @param colorBy auto, axis, field, rgb, flat
 * @param axis 0 x, 1 y, 2 z
 * @param fixedAxis whether the coordinate is that in the fixed frame
 * @param field that colours
 * @param colors from the least to the greatest value
 * @param reverse begins with the last
 * @param min value of the first colour, or that of the cloud
 * @param max value of the last colour, or that of the cloud
 * @param flat colour of all
 * @param size of a point
 * @param unit of the size
 * @param style of a point
 * @param most points
 */
record PointStyle(
    String colorBy,
    int axis,
    boolean fixedAxis,
    String field,
    ColorRamp colors,
    boolean reverse,
    Optional<Double> min,
    Optional<Double> max,
    Rgba flat,
    float size,
    PointSet.Unit unit,
    PointSet.Style style,
    long most) {
  static PointStyle of(Settings s) {
    return new PointStyle(s.text("color_by"), "xyz".indexOf(s.text("axis")), s.text("axis_frame").equals("fixed"),
        s.text("field"),
        ColorRamp.named(s.text("colors")), s.flag("reverse"), limit(s, "min"), limit(s, "max"),
        ColorSetting.read(s, "color"),
        (float) s.number("size"), s.text("unit").equals("metres") ? PointSet.Unit.METRES : PointSet.Unit.PIXELS,
        s.text("style").equals("disc") ? PointSet.Style.DISC : PointSet.Style.SQUARE, s.integer("most_points"));
  }

  /** What colours a cloud: auto resolved by the fields that it has. */
  String colorBy(PointCloud cloud) {
    if (!colorBy.equals("auto")) {
      return colorBy;
    }
    if (Packed.in(cloud).isPresent()) {
      return "rgb";
    }
    return cloud.field(field).isPresent() ? "field" : "axis";
  }

  private static Optional<Double> limit(Settings s, String name) {
    return s.has(name) ? Optional.of(s.number(name)) : Optional.empty();
  }
}
