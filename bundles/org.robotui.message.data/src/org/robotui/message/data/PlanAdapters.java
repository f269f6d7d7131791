package org.robotui.message.data;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.joint.DisplayedTrajectory;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointTrajectory;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.message.ros.geometry_msgs.WrenchStamped;
import org.robotui.message.ros.trajectory_msgs.JointTrajectoryPoint;

/** What planners and controllers say: poses, trajectories, forces. */
final class PlanAdapters {
  private static final double NANOS = 1e9;

  private PlanAdapters() {}

  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.of(org.robotui.message.ros.geometry_msgs.PoseArray.class, PoseArray.class,
            (m, names) -> new PoseArray(names.frame(m.header().frameId()),
                m.poses().stream().map(Geometry::transform).toList()),
            m -> m.header().stamp()),
        Adapter.of(WrenchStamped.class, Wrench.class,
            (m, names) -> new Wrench(names.frame(m.header().frameId()), Geometry.vector(m.wrench().force()),
                Geometry.vector(m.wrench().torque())),
            m -> m.header().stamp()),
        Adapter.of(org.robotui.message.ros.trajectory_msgs.JointTrajectory.class, JointTrajectory.class,
            (m, names) -> new JointTrajectory(m.jointNames(), m.points().stream().map(PlanAdapters::point).toList()),
            m -> m.header().stamp()),
        Adapter.ofDynamic("moveit_msgs/DisplayTrajectory", DisplayedTrajectory.class,
            (m, names) -> displayed(new MessageRecord(m))));
  }

  private static JointTrajectory.Point point(JointTrajectoryPoint p) {
    return new JointTrajectory.Point(p.timeFromStart() / NANOS, Doubles.wrap(p.positions()),
        Doubles.wrap(p.velocities()),
        Doubles.wrap(p.accelerations()), Doubles.wrap(p.effort()));
  }

  /**
   * Read by the definition that came with the connection: the type is of a package that is seldom installed where
   * robots are watched.
   */
  private static DisplayedTrajectory displayed(DynamicRecord m) {
    List<JointTrajectory> parts = items(m, "trajectory").map(PlanAdapters::part).toList();
    return new DisplayedTrajectory(text(m, "model_id"), start(m), parts);
  }

  private static JointTrajectory part(DynamicRecord m) {
    List<String> joints = texts(m, "joint_trajectory.joint_names");
    return new JointTrajectory(joints, items(m, "joint_trajectory.points").map(PlanAdapters::point).toList());
  }

  private static JointTrajectory.Point point(DynamicRecord m) {
    long nanos = at(m, "time_from_start") instanceof FieldValue.Time time ? time.nanos() : 0;
    return new JointTrajectory.Point(nanos / NANOS, numbers(m, "positions"), numbers(m, "velocities"),
        numbers(m, "accelerations"),
        numbers(m, "effort"));
  }

  private static List<JointState.Joint> start(DynamicRecord m) {
    List<String> names = texts(m, "trajectory_start.joint_state.name");
    Doubles positions = numbers(m, "trajectory_start.joint_state.position");
    List<JointState.Joint> joints = new ArrayList<>();
    for (int i = 0; i < Math.min(names.size(), positions.size()); i++) {
      joints.add(new JointState.Joint(names.get(i), positions.get(i), Double.NaN, Double.NaN));
    }
    return joints;
  }

  private static FieldValue at(DynamicRecord m, String path) {
    Optional<FieldValue> value = FieldPath.parse(path).in(m);
    return value.orElseThrow(() -> new IllegalArgumentException(m.schema() + " has no field " + path));
  }

  private static String text(DynamicRecord m, String path) {
    return at(m, path) instanceof FieldValue.Text text ? text.value() : "";
  }

  private static Doubles numbers(DynamicRecord m, String path) {
    return at(m, path) instanceof FieldValue.Numbers numbers ? numbers.values() : Doubles.EMPTY;
  }

  private static Stream<DynamicRecord> items(DynamicRecord m, String path) {
    return at(m, path) instanceof FieldValue.Items items
        ? items.values().stream().filter(FieldValue.Nested.class::isInstance).map(v -> ((FieldValue.Nested) v).value())
        : Stream.empty();
  }

  private static List<String> texts(DynamicRecord m, String path) {
    return at(m, path) instanceof FieldValue.Items items
        ? items.values().stream().filter(FieldValue.Text.class::isInstance).map(v -> ((FieldValue.Text) v).value())
            .toList()
        : List.of();
  }
}
