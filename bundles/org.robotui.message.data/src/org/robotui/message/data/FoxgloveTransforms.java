package org.robotui.message.data;

import java.util.List;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;

/** Transforms in the schemas of Foxglove, {@code FrameTransform} and {@code FrameTransforms}. */
public final class FoxgloveTransforms {
  private static final String MANY = "transforms";

  private FoxgloveTransforms() {}

  /**
   * Whether messages of a type are transforms.
   *
   * @param type the name of a type
   * @return true for both schemas, by each of their names
   */
  public static boolean is(String type) {
    return List.of(FoxgloveAdapters.NAMES, FoxgloveAdapters.ROS_PACKAGE).stream()
        .anyMatch(prefix -> type.equals(prefix + "FrameTransform") || type.equals(prefix + "FrameTransforms"));
  }

  /**
   * The message of ROS that says the same.
   *
   * @param record a message of one of the types
   * @return the transforms
   */
  public static TFMessage message(DynamicRecord record) {
    NamedFields m = new NamedFields(record);
    List<NamedFields> all = record.fields().contains(MANY) ? m.each(MANY) : List.of(m);
    return new TFMessage(all.stream().map(FoxgloveTransforms::transform).toList());
  }

  static long nanos(DynamicRecord record) {
    TFMessage message = message(record);
    return message.transforms().isEmpty() ? 0 : message.transforms().getFirst().header().stamp();
  }

  private static TransformStamped transform(NamedFields m) {
    return new TransformStamped(new Header(0, m.nanos("timestamp"), m.text("parent_frame_id")),
        m.text("child_frame_id"), new Transform(vector(m.inner("translation")), rotation(m.inner("rotation"))));
  }

  static Vector3 vector(NamedFields m) {
    return new Vector3(m.number("x"), m.number("y"), m.number("z"));
  }

  static Quaternion rotation(NamedFields m) {
    return new Quaternion(m.number("x"), m.number("y"), m.number("z"), m.number("w"));
  }
}
