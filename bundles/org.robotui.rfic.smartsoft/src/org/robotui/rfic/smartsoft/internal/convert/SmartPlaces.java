package org.robotui.rfic.smartsoft.internal.convert;

import java.util.List;
import java.util.Map;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Battery;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.DynamicMessage;

/** Where the robot is, and goes. */
public final class SmartPlaces {
  /** Lengths are in millimetres. */
  public static final double PER_METRE = 1e3;
  private static final double PERCENT = 100;
  private static final int AXES = 6;
  private static final int YAW = 5;
  private static final int PLANAR = 3;

  private SmartPlaces() {}

  /** A {@code CommPose3d}: turned about z first, then y, then x. */
  public static RigidTransform pose(DynamicMessage pose) {
    return new RigidTransform(
        new Vector3(ObjectFields.of(pose, "position.x") / PER_METRE, ObjectFields.of(pose, "position.y") / PER_METRE,
            ObjectFields.of(pose, "position.z") / PER_METRE),
        Quaternion.fromRollPitchYaw(ObjectFields.of(pose, "orientation.roll"),
            ObjectFields.of(pose, "orientation.elevation"),
            ObjectFields.of(pose, "orientation.azimuth")));
  }

  /** Where its wheels say that it is, of a {@code CommBaseState}. */
  public static RigidTransform driven(DynamicMessage state) {
    return pose(ObjectFields.within(state, "baseOdomPose.pose3D"));
  }

  /** Where it is, corrected by localisation, of a {@code CommBaseState}. */
  public static RigidTransform corrected(DynamicMessage state) {
    return pose(ObjectFields.within(state, "basePose.pose3D"));
  }

  public static Odometry odometry(DynamicMessage state, RobotFrames frames) {
    DynamicMessage speed = ObjectFields.within(state, "baseVelocity");
    return new Odometry(frames.odom(), frames.base(), driven(state), Doubles.EMPTY,
        new Vector3(ObjectFields.of(speed, "vX") / PER_METRE, ObjectFields.of(speed, "vY") / PER_METRE,
            ObjectFields.of(speed, "vZ") / PER_METRE),
        new Vector3(ObjectFields.of(speed, "wX"), ObjectFields.of(speed, "wY"), ObjectFields.of(speed, "wZ")),
        Doubles.EMPTY);
  }

  /** The covariance is that of x, y and azimuth, in mm and rad, where it is said to be valid. */
  public static PoseEstimate estimate(DynamicMessage state, RobotFrames frames) {
    DynamicMessage pose = ObjectFields.within(state, "basePose");
    double[] told = ObjectFields.numbers(pose, "covMatrix");
    boolean valid = ObjectFields.of(pose, "covInvalid") == 0 && told.length == PLANAR * PLANAR;
    return new PoseEstimate(frames.map(), corrected(state), valid ? covariance(told) : Doubles.EMPTY);
  }

  private static Doubles covariance(double[] told) {
    int[] axes = {0, 1, YAW};
    double[] scale = {1 / PER_METRE, 1 / PER_METRE, 1};
    double[] all = new double[Odometry.COVARIANCE_SIZE];
    for (int i = 0; i < PLANAR; i++) {
      for (int j = 0; j < PLANAR; j++) {
        all[axes[i] * AXES + axes[j]] = told[i * PLANAR + j] * scale[i] * scale[j];
      }
    }
    return Doubles.wrap(all);
  }

  public static Battery battery(DynamicMessage state) {
    DynamicMessage battery = ObjectFields.within(state, "batteryState");
    return new Battery(ObjectFields.of(battery, "potential"), ObjectFields.of(battery, "current"),
        Math.clamp(ObjectFields.of(battery, "chargeLevel") / PERCENT, 0, 1),
        ObjectFields.of(battery, "externalPower") == 0
            ? Battery.Status.DISCHARGING
            : Battery.Status.CHARGING);
  }

  /** A {@code CommPose3dWithCovariance}; the order of its covariance is not told. */
  public static PoseEstimate located(DynamicMessage object, FrameId map) {
    return new PoseEstimate(map, pose(ObjectFields.within(object, "pose")), Doubles.EMPTY);
  }

  public static PoseArray particles(DynamicMessage object, FrameId map) {
    return new PoseArray(map, ObjectFields.list(object, "particles").stream()
        .map(particle -> pose(ObjectFields.within(particle, "pose"))).toList());
  }

  /** The next point of the way, and the goal. */
  public static Path goal(DynamicMessage object, FrameId map) {
    return new Path(map, List.of(point(object, "WayPoint"), point(object, "GoalPoint")));
  }

  private static RigidTransform point(DynamicMessage object, String name) {
    return RigidTransform.planar(ObjectFields.of(object, "x" + name) / PER_METRE,
        ObjectFields.of(object, "y" + name) / PER_METRE,
        0);
  }

  /** The fields of a {@code CommNavigationVelocity}. */
  public static Map<String, Double> velocity(VelocityCommand command) {
    return Map.of("vX", command.linear().x() * PER_METRE, "vY", command.linear().y() * PER_METRE, "omega",
        command.angular().z());
  }
}
