package org.robotui.rfic.carmen.internal.convert;

import java.util.List;
import org.robotui.api.session.RobotFrames;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForm;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** Where the robot is, believes to be, and goes. */
public final class CarmenPlaces {
  private static final int AXES = 6;
  private static final int YAW = 5;
  private static final int GAUSSIAN = 2;
  private static final int REACHED = 0;
  private static final int STOPPED = 1;
  /** Of a place that a user points at without saying how sure it is. */
  private static final double[] UNSURE = {0.2, 0.2, 0.1};

  private CarmenPlaces() {}

  public static RigidTransform pose(IpcRecord pose) {
    return RigidTransform.planar(finite(pose, "x"), finite(pose, "y"), finite(pose, "theta"));
  }

  static double finite(IpcRecord record, String field) {
    double value = record.number(field);
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(field + " is " + value);
    }
    return value;
  }

  public static Odometry odometry(IpcRecord m, RobotFrames frames) {
    return new Odometry(frames.odom(), frames.base(), pose(m), Doubles.EMPTY, new Vector3(finite(m, "tv"), 0, 0),
        new Vector3(0, 0, finite(m, "rv")), Doubles.EMPTY);
  }

  /** The covariance of x and y is not a number where the filter has none. */
  public static PoseEstimate estimate(IpcRecord m, RobotFrames frames) {
    IpcRecord std = m.record("globalpos_std");
    double[] covariance = new double[Odometry.COVARIANCE_SIZE];
    covariance[0] = square(std.number("x"));
    covariance[AXES + 1] = square(std.number("y"));
    covariance[YAW * AXES + YAW] = square(std.number("theta"));
    double xy = m.number("globalpos_xy_cov");
    covariance[1] = Double.isFinite(xy) ? xy : 0;
    covariance[AXES] = covariance[1];
    return new PoseEstimate(frames.map(), pose(m.record("globalpos")), Doubles.wrap(covariance));
  }

  private static double square(double value) {
    return Double.isFinite(value) ? value * value : 0;
  }

  public static PoseEstimate truth(IpcRecord m, RobotFrames frames) {
    return new PoseEstimate(frames.map(), pose(m.record("truepose")), Doubles.EMPTY);
  }

  public static PoseArray particles(IpcRecord m, RobotFrames frames) {
    return new PoseArray(frames.map(), m.records("particles").stream().map(CarmenPlaces::pose).toList());
  }

  public static Path plan(IpcRecord m, FrameId map) {
    return new Path(map, m.records("path").stream().map(CarmenPlaces::pose).toList());
  }

  /** The goal is named by where it is. */
  public static NavigationStatus status(IpcRecord m) {
    boolean goal = m.whole("goal_set") != 0;
    boolean drives = m.whole("autonomous") != 0;
    IpcRecord at = m.record("goal");
    return new NavigationStatus(goal ? at.number("x") + ", " + at.number("y") : "",
        goal && drives ? NavigationStatus.State.ACTIVE : NavigationStatus.State.CANCELED,
        !goal ? "no goal is set" : drives ? "drives to its goal" : "has a goal, and waits to be told to go");
  }

  public static NavigationStatus ended(IpcRecord m) {
    return switch (m.whole("reason")) {
      case REACHED -> new NavigationStatus("", NavigationStatus.State.SUCCEEDED, "the goal was reached");
      case STOPPED -> new NavigationStatus("", NavigationStatus.State.CANCELED, "somebody stopped it");
      default -> new NavigationStatus("", NavigationStatus.State.ABORTED, "the navigator gave up");
    };
  }

  public static double[] planar(RigidTransform pose) {
    return new double[]{pose.translation().x(), pose.translation().y(), pose.rotation().yaw()};
  }

  /** One Gaussian around the pose. */
  public static IpcRecord initialise(IpcForm form, PoseEstimate said, double seconds, String host) {
    Doubles covariance = said.covariance();
    double[] std = covariance.size() == 0 ? UNSURE
        : new double[]{Math.sqrt(covariance.get(0)), Math.sqrt(covariance.get(AXES + 1)),
            Math.sqrt(covariance.get(YAW * AXES + YAW))};
    return form.make().number("distribution", GAUSSIAN).structs("mean", List.of(planar(said.pose())))
        .structs("std", List.of(std)).number("timestamp", seconds).text("host", host).build();
  }
}
