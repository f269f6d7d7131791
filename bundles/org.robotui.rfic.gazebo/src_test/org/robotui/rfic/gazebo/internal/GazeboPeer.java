package org.robotui.rfic.gazebo.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
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
import org.robotui.testkit.rfic.ProcessPeer;
import org.robotui.testkit.rfic.Sample;

/** A simulator in a process of its own: see {@link SimulatorProcess}. */
final class GazeboPeer extends ProcessPeer {
  private static final Optional<Stamp> MEASURED = Optional.of(new Stamp(SimulatorProcess.STAMP, ClockKind.ROBOT));
  private static final Sample POSE = new Sample("odom", new Odometry(new FrameId("robby", "odom"),
      new FrameId("robby", "base_link"), new RigidTransform(new Vector3(2, -1, 0.5), Quaternion.fromYaw(0.2)),
      Doubles.EMPTY, new Vector3(0.2, 0.3, 0.4), new Vector3(-0.1, -0.2, 0.6),
      Doubles.EMPTY), MEASURED);
  private static final Sample SCAN = new Sample("scan", new LaserScan(new FrameId("robby", "laser"), -1, 1, 0.1, 30,
      0, Floats.of(1, Float.NaN, Float.POSITIVE_INFINITY), Floats.EMPTY), MEASURED);

  private final String partition;

  GazeboPeer() {
    // Tests that run at the same time keep apart.
    this(UUID.randomUUID().toString());
  }

  private GazeboPeer(String partition) {
    super(SimulatorProcess.class, partition);
    this.partition = partition;
  }

  @Override
  public Rfic create(RficContext context) {
    return GazeboCase.rfic(context, Map.of("partition", partition, "velocity", List.of("cmd_vel")));
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }
}
