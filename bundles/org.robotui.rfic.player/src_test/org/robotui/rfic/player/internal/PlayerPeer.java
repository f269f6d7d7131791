package org.robotui.rfic.player.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.guard.Guards;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.ServerOptions;
import org.robotui.player.server.TypedHandler;
import org.robotui.testkit.rfic.GatedPeer;
import org.robotui.testkit.rfic.Sample;

/** A base with a laser behind our Player server, behind a gate(). */
final class PlayerPeer extends GatedPeer {
  private static final double STAMP = 1.7e9;
  private static final Optional<Stamp> STAMPED = Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT));
  private static final Sample POSE = new Sample("position2d:0",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"),
          RigidTransform.planar(1, -2, 0.5), Doubles.EMPTY, new Vector3(0.3, 0.1, 0), new Vector3(0, 0, -0.2),
          Doubles.EMPTY),
      STAMPED);
  private static final Sample SCAN =
      new Sample("laser:0", new LaserScan(new FrameId("robby", "laser_0"), -1, 1, 0, 8, 0,
          Floats.of(1.5f, Float.POSITIVE_INFINITY, 2.5f), Floats.of(1, 2, 200)), STAMPED);

  private final Layouts layouts = Layouts.standard();
  private final boolean guard;
  private Optional<PlayerServer> server = Optional.empty();
  private Map<Sample, ServedDevice> devices = Map.of();

  PlayerPeer(boolean guard) {
    this.guard = guard;
  }

  @Override
  public Rfic create(RficContext context) {
    return PlayerSessions.rfic(context,
        PlayerRficCase.settings(Map.of("host", "127.0.0.1", "port", (long) port(), "guard", guard), Map.of()),
        new Guards());
  }

  @Override
  public void start() throws IOException {
    PlayerServer opened = new PlayerServer(layouts, ServerOptions.loopback(THREADS, 0, () -> STAMP));
    TypedHandler base = new TypedHandler(layouts, count -> {}).on(Position2d.VELOCITY, v -> hears(velocity(v)));
    devices = Map.of(POSE, opened.add("position2d", 0, "driver", base),
        SCAN, opened.add("laser", 0, "driver", new TypedHandler(layouts, count -> {})));
    server = Optional.of(opened);
    gate().open(opened.port());
  }

  private static VelocityCommand velocity(Position2d.Velocity v) {
    return new VelocityCommand(new Vector3(v.velocity().x(), v.velocity().y(), 0),
        new Vector3(0, 0, v.velocity().yaw()));
  }

  @Override
  public void kill() {
    gate().shut();
    server.ifPresent(PlayerServer::close);
    server = Optional.empty();
    devices = Map.of();
  }

  @Override
  public void garble() {
    devices.get(SCAN).publish(1, ByteBuffer.wrap(new byte[]{1, 2, 3}), STAMP);
    byte[] garbage = new byte[256];
    Arrays.fill(garbage, (byte) 0xff);
    gate().inject(garbage);
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public void say(Sample sample) {
    Optional<ServedDevice> device = Optional.ofNullable(devices.get(sample));
    if (sample.equals(POSE)) {
      device.ifPresent(d -> d.publish(Position2d.STATE,
          new Position2d.State(new Pose2d(1, -2, 0.5), new Pose2d(0.3, 0.1, -0.2), false), STAMP));
    } else {
      Laser.Scan scan = new Laser.Scan(-1, 1, 1, 8, new float[]{1.5f, 8, 2.5f}, new byte[]{1, 2, (byte) 200}, 5);
      device.ifPresent(d -> d.publish(Laser.SCAN, scan, STAMP));
    }
  }

  @Override
  public int listeners(Sample sample) {
    return Optional.ofNullable(devices.get(sample)).map(ServedDevice::clients).orElse(0);
  }

  @Override
  public String motionPort() {
    return "position2d:0/velocity";
  }

  @Override
  public Motion<?> motion() {
    return new VelocityCommand(new Vector3(0.3, 0.1, 0), new Vector3(0, 0, -0.2));
  }

  @Override
  public Set<String> registrations() {
    return Stream.of(POSE, SCAN).filter(sample -> listeners(sample) > 0).map(sample -> sample.port() + " is open")
        .collect(Collectors.toSet());
  }
}
