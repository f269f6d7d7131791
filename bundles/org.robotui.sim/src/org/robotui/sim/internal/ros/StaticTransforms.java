package org.robotui.sim.internal.ros;

import java.util.ArrayList;
import java.util.List;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ros.msgs.geometry_msgs.TransformStamped;
import org.robotui.ros.msgs.std_msgs.Header;
import org.robotui.ros.msgs.tf2_msgs.TFMessage;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.sensor.LidarSpec;
import org.robotui.sim.internal.sensor.SonarRing;
import org.robotui.sim.internal.world.Pose2;

/** Where the sensors sit on the robot. */
final class StaticTransforms {
  private final Frames frames;

  StaticTransforms(Frames frames) {
    this.frames = frames;
  }

  TFMessage message(LaserSpec laser, Lens lens, SonarRing sonars, Stamp stamp) {
    Header base = stamp.header(frames.base());
    List<TransformStamped> all = new ArrayList<>();
    all.add(Poses.stamped(base, frames.laser(), at(laser.forward(), laser.height())));
    all.add(Poses.stamped(base, frames.lidar(), at(LidarSpec.DEMO.forward(), LidarSpec.DEMO.height())));
    all.add(Poses.stamped(base, frames.imu(), at(0, 0.15)));
    all.add(Poses.stamped(base, frames.satellites(), at(-0.15, 0.7)));
    all.add(Poses.stamped(base, frames.camera(), at(lens.forward(), lens.above())));
    all.add(Poses.stamped(stamp.header(frames.camera()), frames.cameraOptical(), optical()));
    for (int i = 0; i < sonars.count(); i++) {
      Pose2 mount = sonars.mount(Pose2.ORIGIN, i);
      all.add(Poses.stamped(base, frames.sonar(i), Poses.transform(mount, SonarRing.HEIGHT)));
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
