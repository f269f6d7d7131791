package org.robotui.rfic.ros2.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.rfic.ros2.internal.graph.SharedDomains;
import org.robotui.testkit.rfic.ProcessPeer;
import org.robotui.testkit.rfic.Sample;

/** A robot of ROS 2 in a process of its own: see {@link RobotProcess}. */
final class Ros2Peer extends ProcessPeer {
  /** Tests that run at the same time keep apart. */
  static final int DOMAIN = 181 + (int) (ProcessHandle.current().pid() % 20);
  private static final Optional<Stamp> MEASURED = Optional.of(new Stamp(RobotProcess.STAMP, ClockKind.ROBOT));
  private static final Sample POSE = new Sample("odom", new Odometry(new FrameId("robby", "odom"),
      new FrameId("robby", "base_link"), new RigidTransform(new Vector3(2, -1, 0.5), Quaternion.fromYaw(0.2)),
      Doubles.wrap(new double[Odometry.COVARIANCE_SIZE]), new Vector3(0.2, 0.3, 0.4), new Vector3(-0.1, -0.2, 0.6),
      Doubles.wrap(new double[Odometry.COVARIANCE_SIZE])), MEASURED);
  private static final Sample SCAN = new Sample("scan", new LaserScan(new FrameId("robby", "laser"), -1, 1, 0.1, 30,
      0.05, Floats.of(1, Float.NaN, Float.POSITIVE_INFINITY), Floats.EMPTY), MEASURED);

  Ros2Peer() {
    super(RobotProcess.class, Integer.toString(DOMAIN));
  }

  @Override
  public Rfic create(RficContext context) {
    return Ros2Sessions.rfic(context, Ros2Case.settings(Map.of("domain", (long) DOMAIN)), new SharedDomains());
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }
}
