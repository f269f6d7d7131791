package org.robotui.uic.topics.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** A record of given fields. */
public record Fields(String schema, Map<String, FieldValue> all) implements DynamicRecord {
  public static Fields odometry(double x) {
    return of("nav_msgs/Odometry",
        "header",
        nested(of("std_msgs/Header", "seq", number(1204), "stamp", new FieldValue.Time(1_795_273_000_123_000_000L),
            "frame_id", new FieldValue.Text("odom"))),
        "child_frame_id", new FieldValue.Text("base_link"),
        "pose", nested(of("geometry_msgs/PoseWithCovariance",
            "pose",
            nested(of("geometry_msgs/Pose", "position", nested(vector(x, -0.31, 0)), "orientation",
                nested(vector(0, 0, 0.18)))),
            "covariance", new FieldValue.Numbers(Doubles.wrap(new double[36])))),
        "twist", nested(
            of("geometry_msgs/Twist", "linear", nested(vector(0.23, 0, 0)), "angular", nested(vector(0, 0, -0.18)))));
  }

  public static Fields of(String schema, Object... namesAndValues) {
    Map<String, FieldValue> all = new LinkedHashMap<>();
    for (int i = 0; i < namesAndValues.length; i += 2) {
      all.put((String) namesAndValues[i], (FieldValue) namesAndValues[i + 1]);
    }
    return new Fields(schema, all);
  }

  public static Fields vector(double x, double y, double z) {
    return of("geometry_msgs/Vector3", "x", number(x), "y", number(y), "z", number(z));
  }

  private static FieldValue number(double value) {
    return new FieldValue.Num(value, value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value));
  }

  private static FieldValue nested(Fields fields) {
    return new FieldValue.Nested(fields);
  }

  @Override
  public List<String> fields() {
    return List.copyOf(all.keySet());
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return Optional.ofNullable(all.get(name));
  }
}
