package org.robotui.bridge.internal.far;

import java.util.List;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.geometry.Vector3;

/** What other values mean where a port takes commands. */
final class FittingCommand {
  private static final List<FieldPath> LINEAR = axes("linear");
  private static final List<FieldPath> ANGULAR = axes("angular");

  private FittingCommand() {}

  private static List<FieldPath> axes(String part) {
    return List.of("x", "y", "z").stream().map(axis -> FieldPath.parse(part + "." + axis)).toList();
  }

  /** A pose is a goal where goals are taken, and a record with the fields of a velocity is one; else the value. */
  static Data of(Class<?> wanted, Data value) {
    if (wanted == NavigationGoal.class && value instanceof StampedPose pose) {
      return new NavigationGoal(pose.frame(), pose.pose());
    }
    boolean moves = wanted == VelocityCommand.class && value instanceof DynamicRecord record
        && (record.field("linear").isPresent() || record.field("angular").isPresent());
    return moves ? velocity((DynamicRecord) value) : value;
  }

  /** What is not written is zero. */
  private static VelocityCommand velocity(DynamicRecord record) {
    return new VelocityCommand(vector(record, LINEAR), vector(record, ANGULAR));
  }

  private static Vector3 vector(DynamicRecord record, List<FieldPath> axes) {
    double[] numbers = axes.stream().mapToDouble(path -> record.number(path).orElse(0)).toArray();
    return new Vector3(numbers[0], numbers[1], numbers[2]);
  }
}
