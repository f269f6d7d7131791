package org.robotui.sim.internal.message;

import java.util.ArrayList;
import java.util.List;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.sensor.SonarSpec;

/** Where the sensors sit on the robot. */
final class StaticTransforms {
  private final Frames frames;

  StaticTransforms(Frames frames) {
    this.frames = frames;
  }

  TFMessage message(RobotModel robot, Stamp stamp) {
    Header base = stamp.header(frames.base());
    List<TransformStamped> all = new ArrayList<>();
    all.add(Poses.stamped(base, frames.laser(), at(robot.laser().forward(), robot.laser().height())));
    robot.lidar().ifPresent(lidar -> all.add(Poses.stamped(base, frames.lidar(), at(lidar.forward(), lidar.height()))));
    all.add(Poses.stamped(base, frames.imu(), at(0, Math.min(0.15, robot.height() / 2))));
    all.add(Poses.stamped(base, frames.satellites(), at(-0.6 * robot.radius(), robot.height() + 0.05)));
    all.add(Poses.stamped(base, frames.camera(), at(robot.lens().forward(), robot.lens().above())));
    all.add(Poses.stamped(stamp.header(frames.camera()), frames.cameraOptical(), optical()));
    SonarSpec sonars = robot.sonars();
    for (int i = 0; i < sonars.count(); i++) {
      all.add(Poses.stamped(base, frames.sonar(i), Poses.transform(sonars.mounts().get(i), sonars.height())));
    }
    return new TFMessage(all);
  }

  private static RigidTransform at(double forward, double height) {
    return new RigidTransform(new Vector3(forward, 0, height), Quaternion.IDENTITY);
  }

  private static RigidTransform optical() {
    return new RigidTransform(Vector3.ZERO, Quaternion.fromRollPitchYaw(-Math.PI / 2, 0, -Math.PI / 2));
  }
}
