package org.robotui.message.data;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.data.Data;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.message.roboframe.TargetStreamable;
import org.robotui.message.roboframe.VelocityStreamable;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistStamped;
import org.robotui.message.ros.std_msgs.Header;

/**
 * How a command becomes a ROS message.
 *
 * @param <D> the data type
 * @param <M> the record of a message
 * @param type the ROS type
 * @param data the data type
 * @param form the record of the messages
 * @param message turns one into the other, with the present time in nanoseconds
 * @param named whether only topics that the configuration names take it: of others that are subscribed to, most show
 * what the robot plans
 * @param help a sentence for users
 */
public record CommandType<D extends Data, M extends Record>(
    String type, Class<D> data, Class<M> form, Stamped<D, M> message, boolean named, String help) {
  /**
   * Makes a message.
   *
   * @param <D> the data type
   * @param <M> the Java value of a message
   */
  @FunctionalInterface
  public interface Stamped<D, M> {
    /**
     * Makes a message.
     *
     * @param command the command
     * @param nowNanos the robot's time
     * @return the message
     */
    M of(D command, long nowNanos);
  }

  private static final List<CommandType<?, ?>> ALL = List.of(
      new CommandType<>("geometry_msgs/Twist", VelocityCommand.class, Twist.class, (c, now) -> twist(c), false,
          "Velocity of the base."),
      new CommandType<>("geometry_msgs/TwistStamped", VelocityCommand.class, TwistStamped.class,
          (c, now) -> new TwistStamped(new Header(0, now, ""), twist(c)), false, "Velocity of the base."),
      new CommandType<>("geometry_msgs/PoseStamped", NavigationGoal.class, PoseStamped.class,
          (c, now) -> new PoseStamped(new Header(0, now, c.frame().name()), Geometry.pose(c.pose())), false,
          "Where the robot shall go."),
      new CommandType<>("geometry_msgs/PoseWithCovarianceStamped", PoseEstimate.class, PoseWithCovarianceStamped.class,
          CommandType::estimate, false, "Where the robot is, for its localisation."),
      new CommandType<>("nav_msgs/Path", Path.class, org.robotui.message.ros.nav_msgs.Path.class, CommandType::path,
          true,
          "Poses to drive to, one after the other."),
      new CommandType<>("geometry_msgs/PoseArray", PoseArray.class,
          org.robotui.message.ros.geometry_msgs.PoseArray.class,
          (c, now) -> new org.robotui.message.ros.geometry_msgs.PoseArray(new Header(0, now, c.frame().name()),
              c.poses().stream().map(Geometry::pose).toList()),
          true, "Poses to drive to, one after the other."),
      new CommandType<>("roboframe/Velocity", VelocityCommand.class, VelocityStreamable.class,
          (c, now) -> RoboframeMessages.velocity(c), false, "Velocity of the base."),
      new CommandType<>("roboframe/Target", NavigationGoal.class, TargetStreamable.class,
          (c, now) -> RoboframeMessages.target(c), false, "Where the robot shall go."));

  /**
   * The command for a topic's type.
   *
   * @param type a ROS type
   * @return how to command it, or none where it is no command we know
   */
  public static Optional<CommandType<?, ?>> of(String type) {
    return ALL.stream().filter(c -> c.type().equals(type)).<CommandType<?, ?>>map(Function.identity()).findFirst();
  }

  /** The same for what is said, in place of commanded. */
  static List<DataMessages.Maker<?, ?>> makers() {
    return ALL.stream().<DataMessages.Maker<?, ?>>map(CommandType::maker).toList();
  }

  private DataMessages.Maker<D, M> maker() {
    return DataMessages.Maker.of(data, form, message);
  }

  private static Twist twist(VelocityCommand c) {
    return new Twist(Geometry.vector(c.linear()), Geometry.vector(c.angular()));
  }

  private static PoseWithCovarianceStamped estimate(PoseEstimate c, long now) {
    return new PoseWithCovarianceStamped(new Header(0, now, c.frame().name()),
        new PoseWithCovariance(Geometry.pose(c.pose()), covariance(c.covariance())));
  }

  private static org.robotui.message.ros.nav_msgs.Path path(Path c, long now) {
    Header header = new Header(0, now, c.frame().name());
    return new org.robotui.message.ros.nav_msgs.Path(header,
        c.poses().stream().map(pose -> new PoseStamped(header, Geometry.pose(pose))).toList());
  }

  static double[] covariance(Doubles given) {
    double[] covariance = new double[Odometry.COVARIANCE_SIZE];
    if (given.size() > 0) {
      given.buffer().get(covariance);
    }
    return covariance;
  }
}
