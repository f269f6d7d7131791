package org.robotui.rfic.smartsoft.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.net.SocketFactory;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.config.Settings;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
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
import org.robotui.guard.Guards;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.net.socket.HostPort;
import org.robotui.smartsoft.naming.NamingClient;
import org.robotui.smartsoft.naming.NamingService;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.server.PushServer;
import org.robotui.smartsoft.server.SendServer;
import org.robotui.smartsoft.server.SmartServerOptions;
import org.robotui.smartsoft.server.PatternServer;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.Gate;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.Sample;

/** A robot of SmartSoft: a naming service and one component of ours, each service behind a gate of its own. */
final class SmartPeer implements Peer {
  private static final CommTypes TYPES = CommTypes.shipped();
  private static final String BASE_STATE = "CommBasicObjects::CommBaseState";
  private static final String SCAN_TYPE = "CommBasicObjects::CommMobileLaserScan";
  private static final String VELOCITY = "CommBasicObjects::CommNavigationVelocity";
  private static final Map<String, Object> TIME = Map.of("sec", 1_700_000_000L);
  private static final Optional<Stamp> STAMPED = Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT));
  private static final Sample STATE = new Sample("base/state",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"),
          new RigidTransform(new Vector3(1, -2, 0), Quaternion.fromRollPitchYaw(0, 0, 0.5)), Doubles.EMPTY,
          new Vector3(0.3, 0.1, 0), new Vector3(0, 0, -0.2), Doubles.EMPTY),
      STAMPED);
  private static final Sample SCAN = new Sample("base/laser",
      new LaserScan(new FrameId("robby", "base/laser"), Math.toRadians(0.01) * 27_000 - 2 * Math.PI,
          Math.toRadians(0.01) * 50, 0.02, 8, 0, Floats.of(1.5f, Float.POSITIVE_INFINITY, 2.5f),
          Floats.of(1, 0, 200)),
      STAMPED);

  private final List<Data> heard = new CopyOnWriteArrayList<>();
  private final boolean guard;
  private final Map<String, Gate> gates = new HashMap<>();
  private final List<PatternServer> servers = new ArrayList<>();
  private final Map<Sample, PushServer> pushing = new HashMap<>();
  private Optional<NamingService> naming = Optional.empty();

  SmartPeer(boolean guard) {
    this.guard = guard;
    try {
      for (String each : List.of("naming", "state", "laser", "drive")) {
        gates.put(each, new Gate());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public Map<Capability, String> lacks() {
    return Map.of();
  }

  @Override
  public Rfic create(RficContext context) {
    return SmartSessions.rfic(context,
        settings(Map.of("host", "127.0.0.1", "port", (long) gates.get("naming").port(), "guard", guard)),
        new Guards());
  }

  static SmartSettings settings(Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    SmartSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    return SmartSettings.of(new Settings(SmartSettings.SCHEMA, values), Map.of());
  }

  @Override
  public void start() throws IOException {
    SmartServerOptions options = SmartServerOptions.loopback(THREADS);
    NamingService opened = new NamingService(THREADS, InetAddress.getLoopbackAddress(), 0);
    naming = Optional.of(opened);
    PushServer state = new PushServer(options, Duration.ZERO);
    PushServer laser = new PushServer(options, Duration.ZERO);
    SendServer drive = new SendServer(options, object -> hear(TYPES.get(VELOCITY).read(object)));
    pushing.put(STATE, state);
    pushing.put(SCAN, laser);
    try (NamingClient client = NamingClient.connect(new HostPort("127.0.0.1", opened.port()),
        SocketFactory.getDefault(), Duration.ofSeconds(20))) {
      enter(client, "Push", "state", BASE_STATE, state);
      enter(client, "Push", "laser", SCAN_TYPE, laser);
      enter(client, "Send", "drive", VELOCITY, drive);
    }
    gates.get("naming").open(opened.port());
  }

  private void enter(NamingClient client, String pattern, String service, String type, PatternServer server)
      throws IOException {
    servers.add(server);
    Gate gate = gates.get(service);
    gate.open(server.address().at().port());
    client.bind(new ServiceName("base", pattern, service, List.of(type)),
        new ServiceAddress(new HostPort("127.0.0.1", gate.port()), server.address().identifier()));
  }

  private void hear(DynamicMessage velocity) {
    heard.add(new VelocityCommand(
        new Vector3(velocity.number("vX").orElseThrow() / 1000, velocity.number("vY").orElseThrow() / 1000, 0),
        new Vector3(0, 0, velocity.number("omega").orElseThrow())));
  }

  @Override
  public void kill() {
    gates.values().forEach(Gate::shut);
    servers.forEach(PatternServer::close);
    servers.clear();
    pushing.clear();
    naming.ifPresent(NamingService::close);
    naming = Optional.empty();
  }

  @Override
  public void hang() {
    gates.values().forEach(Gate::hold);
  }

  @Override
  public void goOn() {
    gates.values().forEach(Gate::goOn);
  }

  @Override
  public void garble() throws IOException {
    push(SCAN, scan(Double.NaN));
    byte[] garbage = new byte[256];
    Arrays.fill(garbage, (byte) 0xff);
    gates.values().forEach(gate -> gate.inject(garbage));
  }

  @Override
  public List<Sample> samples() {
    return List.of(STATE, SCAN);
  }

  @Override
  public void say(Sample sample) throws IOException {
    push(sample, sample.equals(STATE) ? state() : scan(27_000));
  }

  private void push(Sample sample, Map<String, Object> object) throws IOException {
    PushServer server = pushing.get(sample);
    if (server != null) {
      try {
        server.put(TYPES.get(sample.equals(STATE) ? BASE_STATE : SCAN_TYPE).bytes(object));
      } catch (MessageException e) {
        throw new IOException(e);
      }
    }
  }

  private static Map<String, Object> state() {
    Map<String, Object> pose = Map.of("pose3D", Map.of("position", Map.of("x", 1000, "y", -2000), "orientation",
        Map.of("azimuth", 0.5)), "covInvalid", true);
    return Map.of("timeStamp", TIME, "basePose", pose, "baseOdomPose", pose, "baseVelocity",
        Map.of("vX", 300, "vY", 100, "wZ", -0.2));
  }

  private static Map<String, Object> scan(double start) {
    return Map.of("base_state", state(), "laser_scan_pose",
        Map.of("laser_scan", Map.of("time", TIME, "start_angle", start, "resolution", 50, "length_unit", 10,
            "distance_min", 2, "distance_max", 800, "max_scan_points", 3, "scan_points",
            List.of(Map.of("index", 0, "distance", 150, "intensity", 1),
                Map.of("index", 2, "distance", 250, "intensity", 200))),
            "sensor_pose", Map.of("position", Map.of("x", 200))));
  }

  @Override
  public int listeners(Sample sample) {
    PushServer server = pushing.get(sample);
    return server == null ? 0 : server.subscribers();
  }

  @Override
  public String motionPort() {
    return "velocity";
  }

  @Override
  public Motion<?> motion() {
    return new VelocityCommand(new Vector3(0.3, 0.1, 0), new Vector3(0, 0, -0.2));
  }

  @Override
  public List<Data> heard() {
    return List.copyOf(heard);
  }

  @Override
  public Set<String> registrations() {
    Set<String> registered = new TreeSet<>();
    pushing.forEach((sample, server) -> {
      if (server.subscribers() > 0) {
        registered.add(sample.port() + " is subscribed to");
      }
    });
    return registered;
  }

  @Override
  public int links() {
    return gates.values().stream().mapToInt(Gate::links).sum();
  }

  @Override
  public void close() {
    kill();
    gates.values().forEach(Gate::close);
  }
}
