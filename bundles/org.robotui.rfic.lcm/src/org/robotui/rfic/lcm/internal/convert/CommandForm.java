package org.robotui.rfic.lcm.internal.convert;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Pose;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.rfic.lcm.internal.language.Field;
import org.robotui.rfic.lcm.internal.language.Form;

/**
 * A command that messages may carry.
 *
 * @param <D> the data type
 * @param form its fields
 * @param data the data type
 * @param parts what a command holds by field, in SI units: Double, double[] or String
 * @param sample a command that moves nothing, to try a mapping with
 * @param help a sentence for users
 */
public record CommandForm<D extends Data>(Form form, Class<D> data, Parts<D> parts, D sample, String help) {
  private static final FrameId ANYWHERE = new FrameId("robot", "map");
  private static final String PLACE = "position | x y";
  private static final Map<String, CommandForm<?>> ALL = Stream.of(
      new CommandForm<>(Form.of("velocity", List.of("linear | vx", "angular | wz"),
          MotionShapes.fields(MotionShapes.velocities(), Stream.of(Field.stamp()))), VelocityCommand.class,
          CommandForm::velocity,
          VelocityCommand.ZERO, "Velocity of the base."),
      new CommandForm<>(Form.of("goal", List.of(PLACE), place("pose.frame")), NavigationGoal.class, CommandForm::pose,
          new NavigationGoal(ANYWHERE, RigidTransform.IDENTITY), "Where the robot shall go."),
      new CommandForm<>(Form.of("initial_pose", List.of(PLACE), place("pose.frame")), PoseEstimate.class,
          CommandForm::pose,
          new PoseEstimate(ANYWHERE, RigidTransform.IDENTITY, Doubles.EMPTY),
          "Where the robot is, for its localisation."))
      .collect(Collectors.collectingAndThen(Collectors.toMap(c -> c.form().word(), c -> c, (a, b) -> a, TreeMap::new),
          Collections::unmodifiableMap));

  /**
   * Takes a command apart.
   *
   * @param <D> the data type
   */
  @FunctionalInterface
  public interface Parts<D> {
    /**
     * Takes apart.
     *
     * @param command the command
     * @return its fields: Double, double[] or String
     */
    Map<String, Object> of(D command);
  }

  /**
   * Finds one.
   *
   * @param word after {@code as:}
   * @return the command
   */
  public static Optional<CommandForm<?>> of(String word) {
    return Optional.ofNullable(ALL.get(word));
  }

  /** All words, for messages. */
  public static String words() {
    return String.join(", ", ALL.keySet());
  }

  private static List<Field> place(String otherFrame) {
    List<Field> fields = new ArrayList<>(Poses.fields().toList());
    fields.add(Field.text("frame", "frame", otherFrame));
    fields.add(Field.stamp());
    return fields;
  }

  private static Map<String, Object> velocity(VelocityCommand c) {
    return Map.of("linear", array(c.linear()), "vx", c.linear().x(), "vy", c.linear().y(), "vz", c.linear().z(),
        "angular", array(c.angular()), "wx", c.angular().x(), "wy", c.angular().y(), "wz", c.angular().z());
  }

  private static Map<String, Object> pose(Pose c) {
    Vector3 at = c.pose().translation();
    Quaternion q = c.pose().rotation();
    return Map.of("frame", c.frame().name(), "position", array(at), "x", at.x(), "y", at.y(), "z", at.z(),
        "orientation", new double[]{q.w(), q.x(), q.y(), q.z()}, "roll", q.roll(), "pitch", q.pitch(), "yaw", q.yaw());
  }

  private static double[] array(Vector3 v) {
    return new double[]{v.x(), v.y(), v.z()};
  }
}
