package org.robotui.sim.internal.roboframe;

import java.util.List;
import org.robotui.geometry.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.world.Pose2;

/**
 * Where the parts of the robot are, as transforms of ROS: types of RoboFrame say nothing of that, and an application
 * may use any type.
 *
 * @param robot whose parts
 */
record RoboframePlaces(RobotModel robot) {
  static final String ODOMETRY = "odom";
  static final String BASE = "base_link";
  static final String LASER = "laser";
  static final String OPTICS = "camera_optical";

  TFMessage message(RobotState state, long stamp) {
    Pose2 laser = new Pose2(robot.laser().forward(), 0, 0);
    return new TFMessage(List.of(
        transform(stamp, "map", ODOMETRY, state.mapFromOdometry(), 0, Quaternion.IDENTITY),
        transform(stamp, ODOMETRY, BASE, state.odometry(), 0, Quaternion.IDENTITY),
        transform(stamp, BASE, LASER, laser, robot.laser().height(), Quaternion.IDENTITY),
        transform(stamp, BASE, OPTICS, new Pose2(robot.lens().forward(), 0, 0), robot.lens().above(),
            Quaternion.fromRollPitchYaw(-Math.PI / 2, 0, -Math.PI / 2))));
  }

  private static TransformStamped transform(long stamp, String parent, String child, Pose2 at, double height,
      Quaternion turned) {
    Quaternion q = Quaternion.fromYaw(at.yaw()).times(turned);
    return new TransformStamped(new Header(0, stamp, parent), child, new Transform(
        new Vector3(at.x(), at.y(), height),
        new org.robotui.message.ros.geometry_msgs.Quaternion(q.x(), q.y(), q.z(), q.w())));
  }
}
