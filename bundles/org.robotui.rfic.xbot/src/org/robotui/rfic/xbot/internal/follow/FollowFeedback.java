package org.robotui.rfic.xbot.internal.follow;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.xbot.StateFrame;

/**
 * Where joints are to be, and where they are, as feedback of control_msgs/FollowJointTrajectory.
 *
 * @param names of the joints of the goal
 * @param indices of them in the robot
 */
record FollowFeedback(List<String> names, int[] indices) {
  private static final String FEEDBACK = "control_msgs/FollowJointTrajectoryFeedback";
  private static final String POINT = "trajectory_msgs/JointTrajectoryPoint";
  private static final double SECOND = 1e9;

  static FollowFeedback of(List<String> names, List<String> robot) {
    return new FollowFeedback(names, names.stream().mapToInt(robot::indexOf).toArray());
  }

  /** None where the report or the state has not all of the joints. */
  Optional<DynamicRecord> of(FollowReport report, StateFrame state, long nowNanos) {
    for (int index : indices) {
      boolean known = index >= 0 && index < state.joints().size();
      for (double[] numbers : report.desired()) {
        known &= index < numbers.length;
      }
      if (!known) {
        return Optional.empty();
      }
    }
    return Optional.of(record(report, state.joints(), nowNanos));
  }

  private DynamicRecord record(FollowReport report, List<StateFrame.Joint> joints, long nowNanos) {
    double[][] desired = report.desired();
    long since = (long) (report.seconds() * SECOND);
    IntToDoubleFunction position = i -> joints.get(i).linkPosition();
    IntToDoubleFunction velocity = i -> joints.get(i).linkVelocity();
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("header", new FieldValue.Nested(
        new MapRecord("std_msgs/Header", Map.of("stamp", new FieldValue.Time(nowNanos)))));
    fields.put("joint_names", new FieldValue.Items(names.stream().<FieldValue>map(FieldValue.Text::new).toList()));
    fields.put("desired", point(since, i -> desired[0][i], i -> desired[1][i], i -> desired[2][i]));
    fields.put("actual", point(since, position, velocity));
    fields.put("error", point(since, i -> desired[0][i] - position.applyAsDouble(i),
        i -> desired[1][i] - velocity.applyAsDouble(i)));
    return new MapRecord(FEEDBACK, fields);
  }

  private FieldValue point(long since, IntToDoubleFunction... values) {
    List<String> kinds = List.of("positions", "velocities", "accelerations");
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    for (int kind = 0; kind < values.length; kind++) {
      IntToDoubleFunction value = values[kind];
      double[] numbers = new double[indices.length];
      for (int i = 0; i < numbers.length; i++) {
        numbers[i] = value.applyAsDouble(indices[i]);
      }
      fields.put(kinds.get(kind), new FieldValue.Numbers(Doubles.of(numbers)));
    }
    fields.put("time_from_start", new FieldValue.Time(since));
    return new FieldValue.Nested(new MapRecord(POINT, fields));
  }
}
