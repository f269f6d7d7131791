package org.robotui.ui.control;

import java.util.Arrays;
import java.util.List;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;

/** Forms of messages for tests. */
final class Shapes {
  static final RecordShape POINT =
      shape("geometry_msgs/Point", field("x", new FieldShape.Real(64)), field("y", new FieldShape.Real(64)));

  static final RecordShape HEADER = shape("std_msgs/Header", field("seq", new FieldShape.Whole(32, false)),
      field("stamp", new FieldShape.Time()), field("frame_id", new FieldShape.Text()));

  static final RecordShape TASK = new RecordShape("demo_msgs/Task", List.of(
      field("header", new FieldShape.Nested(HEADER)),
      field("mode", new FieldShape.Whole(8, false)),
      field("speed", new FieldShape.Real(32)),
      field("loop", new FieldShape.Flag()),
      field("label", new FieldShape.Text()),
      field("timeout", new FieldShape.Duration()),
      field("goal", new FieldShape.Nested(POINT)),
      field("covariance", new FieldShape.Many(new FieldShape.Real(64), 4)),
      field("way", new FieldShape.Many(new FieldShape.Nested(POINT), 0)),
      field("names", new FieldShape.Many(new FieldShape.Text(), 0))),
      List.of(new RecordShape.Constant("MODE_IDLE", "0"), new RecordShape.Constant("MODE_DRIVE", "2"),
          new RecordShape.Constant("MAX_SPEED", "1.5"), new RecordShape.Constant("FRAME", "map")));

  private Shapes() {}

  static RecordShape shape(String type, RecordShape.Field... fields) {
    return new RecordShape(type, Arrays.asList(fields), List.of());
  }

  static RecordShape.Field field(String name, FieldShape shape) {
    return new RecordShape.Field(name, shape);
  }
}
