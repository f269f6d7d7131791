package org.robotui.rfic.roboframe.internal;

import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.config.Settings;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.roboframe.OdometryStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.roboframe.VelocityStreamable;
import org.robotui.roboframe.board.Blackboard;
import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.Connector;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.roboframe.board.Router;
import org.robotui.testkit.rfic.GatedPeer;
import org.robotui.testkit.rfic.Sample;

/** A robot of RoboFrame: the blackboard of an application, and its router behind a gate(). */
final class RoboframePeer extends GatedPeer {
  private static final long STAMP = 1_700_000_000_000_000_000L;
  private static final Optional<Stamp> STAMPED = Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT));
  static final ChannelKey<ScanStreamable> SCAN_KEY = ChannelKey.of("laser/scan", ScanStreamable.class);
  static final ChannelKey<OdometryStreamable> ODOMETRY_KEY = ChannelKey.of("odometry", OdometryStreamable.class);
  static final ChannelKey<VelocityStreamable> VELOCITY_KEY = ChannelKey.of("drive/velocity", VelocityStreamable.class);
  private static final Sample ODOMETRY = new Sample("odometry",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base"),
          new RigidTransform(new Vector3(1, -2, 0), Quaternion.fromYaw(0.5)), Doubles.EMPTY,
          new Vector3(0.3, 0.1, 0), new Vector3(0, 0, -0.2), Doubles.EMPTY),
      STAMPED);
  private static final Sample SCAN = new Sample("laser/scan",
      new LaserScan(new FrameId("robby", "laser"), -0.5, 0.25, 0.125, 8, 0,
          Floats.of(1.5f, Float.POSITIVE_INFINITY, 2.5f), Floats.EMPTY),
      STAMPED);

  private Optional<Running> running = Optional.empty();

  /** What there is while the robot is there. */
  private record Running(Router router, KeyOutput<ScanStreamable> scans, KeyOutput<OdometryStreamable> odometry) {}

  @Override
  public Rfic create(RficContext context) {
    return new RoboframeRficType().create(context, settings(port()));
  }

  static RoboframeSettings settings(int port) {
    Map<String, Object> values = new HashMap<>();
    RoboframeSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.put("host", "127.0.0.1");
    values.put("port", (long) port);
    return RoboframeSettings.of(new Settings(RoboframeSettings.SCHEMA, values), Map.of());
  }

  @Override
  public void start() throws IOException {
    Blackboard board = new Blackboard();
    Router router = new Router(board, "robot", List.of(Connector.parse("listen:0")), THREADS);
    running = Optional.of(new Running(router, board.advertise(SCAN_KEY, "laser"),
        board.advertise(ODOMETRY_KEY, "wheels")));
    board.request(VELOCITY_KEY, "drive", posted -> hears(new VelocityCommand(
        new Vector3(posted.value().forward(), posted.value().left(), 0), new Vector3(0, 0, posted.value().turn()))));
    gate().open(router.ports().getFirst());
  }

  @Override
  public void kill() {
    gate().shut();
    running.ifPresent(all -> all.router().close());
    running = Optional.empty();
  }

  @Override
  public void garble() {
    running.ifPresent(all -> all.scans().push(new ScanStreamable(STAMP, "laser", Float.NaN, 0, 0, 0, new float[1])));
    byte[] garbage = new byte[256];
    Arrays.fill(garbage, (byte) 0xff);
    gate().inject(garbage);
  }

  @Override
  public List<Sample> samples() {
    return List.of(ODOMETRY, SCAN);
  }

  @Override
  public void say(Sample sample) {
    running.ifPresent(all -> {
      if (sample.equals(SCAN)) {
        all.scans().push(new ScanStreamable(STAMP, "laser", -0.5f, 0.25f, 0.125f, 8,
            new float[]{1.5f, Float.POSITIVE_INFINITY, 2.5f}));
      } else {
        all.odometry().push(new OdometryStreamable(STAMP, "odom", "base", 1, -2, 0.5, 0.3, 0.1, -0.2));
      }
    });
  }

  @Override
  public int listeners(Sample sample) {
    return running.map(all -> sample.equals(SCAN) ? all.scans().readers() : all.odometry().readers()).orElse(0);
  }

  @Override
  public String motionPort() {
    return VELOCITY_KEY.name();
  }

  @Override
  public Motion<?> motion() {
    return new VelocityCommand(new Vector3(0.3, 0.1, 0), new Vector3(0, 0, -0.2));
  }

  @Override
  public Set<String> registrations() {
    Set<String> all = new TreeSet<>();
    running.ifPresent(there -> there.router().remoteKeys()
        .forEach(key -> all.add((key.writers().isEmpty() ? "reads " : "writes ") + key.name())));
    return all;
  }
}
