package org.robotui.message.data;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;

/** Poses of Gazebo as transforms. They name their frames, or something in the world that has a frame. */
public final class GazeboPoses {
  private GazeboPoses() {}

  /**
   * The frames of a pose.
   *
   * @param parent in which it is
   * @param child which has it
   */
  public record Frames(String parent, String child) {}

  /**
   * What a pose says of whose it is.
   *
   * @param id of something in the world; 0 where it has none
   * @param name of it
   */
  public record Subject(long id, String name) {}

  /**
   * Whether messages of a type are poses with names.
   *
   * @param type the name of a type
   * @return true for {@code Pose_V}
   */
  public static boolean is(String type) {
    return GazeboAdapters.PACKAGES.stream().anyMatch(prefix -> type.equals(prefix + "Pose_V"));
  }

  /**
   * The message of ROS that says the same.
   *
   * @param record poses
   * @param known the frames of what does not name them itself, where they are known
   * @return the transforms
   */
  public static TFMessage message(DynamicRecord record, Function<Subject, Optional<Frames>> known) {
    NamedFields m = new NamedFields(record);
    long stamp = GazeboAdapters.stamp(m);
    List<TransformStamped> all = m.each("pose").stream()
        .flatMap(pose -> frames(pose, known).map(frames -> transform(pose, frames, stamp)).stream()).toList();
    return new TFMessage(all);
  }

  private static Optional<Frames> frames(NamedFields pose, Function<Subject, Optional<Frames>> known) {
    String parent = GazeboAdapters.said(pose, "frame_id");
    String child = GazeboAdapters.said(pose, "child_frame_id");
    return !parent.isEmpty() && !child.isEmpty() && !parent.equals(child) ? Optional.of(new Frames(parent, child))
        : known.apply(new Subject((long) pose.number("id"), pose.text("name")));
  }

  /**
   * A transform.
   *
   * @param pose a pose
   * @param frames its frames
   * @param stamp when it was so, unless it says that itself, nanoseconds
   * @return the transform
   */
  public static TransformStamped transform(DynamicRecord pose, Frames frames, long stamp) {
    return transform(new NamedFields(pose), frames, stamp);
  }

  private static TransformStamped transform(NamedFields pose, Frames frames, long stamp) {
    long own = GazeboAdapters.stamp(pose);
    return new TransformStamped(new Header(0, own == 0 ? stamp : own, frames.parent()), frames.child(),
        new Transform(FoxgloveTransforms.vector(pose.inner("position")),
            FoxgloveTransforms.rotation(pose.inner("orientation"))));
  }
}
