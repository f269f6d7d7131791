package org.robotui.ui.control;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

/** Records for tests. */
final class Records {
  private Records() {}

  static DynamicRecord scan(int rays, double first) {
    double[] ranges = IntStream.range(0, rays).mapToDouble(i -> first + i * 0.5).toArray();
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("header", nested("std_msgs/Header", header()));
    fields.put("angle_min", new FieldValue.Num(-1.57, "-1.57"));
    fields.put("ranges", new FieldValue.Numbers(Doubles.wrap(ranges)));
    fields.put("intensities", new FieldValue.Numbers(Doubles.EMPTY));
    fields.put("ok", new FieldValue.Flag(true));
    fields.put("names", new FieldValue.Items(List.of(new FieldValue.Text("left"), new FieldValue.Text("right"))));
    fields.put("poses", new FieldValue.Items(List.of(pose(1), pose(2))));
    return new MapRecord("sensor_msgs/LaserScan", fields);
  }

  static FieldValue pose(double x) {
    FieldValue position = nested("geometry_msgs/Point", Map.of("x", new FieldValue.Num(x, Double.toString(x))));
    return nested("geometry_msgs/Pose", Map.of("position", position));
  }

  private static Map<String, FieldValue> header() {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("seq", new FieldValue.Num(42, "42"));
    fields.put("stamp", new FieldValue.Time(1_763_737_178_123_456_789L));
    fields.put("frame_id", new FieldValue.Text("laser"));
    return fields;
  }

  private static FieldValue nested(String schema, Map<String, FieldValue> fields) {
    return new FieldValue.Nested(new MapRecord(schema, fields));
  }
}
