package org.robotui.rfic.yarp.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
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
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.net.socket.HostPort;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.Gate;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.Sample;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.name.NameServer;
import org.robotui.yarp.name.YarpAddress;
import org.robotui.yarp.port.PortArrival;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.port.YarpPort;
import org.robotui.yarp.wire.YarpCarrier;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpStamp;

/** A robot of YARP: a name server of ours and three ports, each behind a gate. */
final class YarpPeer implements Peer {
  static final String ODOMETRY = "/odo/odometry:o";
  static final String LASER = "/laser";
  static final String VELOCITY = "/base/data:i";
  private static final String RPC = "/base/rpc:i";
  private static final YarpStamp STAMP = new YarpStamp(7, 1.7e9);
  private static final Optional<Stamp> STAMPED = Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT));
  private static final Sample POSE = new Sample("odo/odometry",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"),
          RigidTransform.planar(1, -2, Math.PI / 2), Doubles.EMPTY, new Vector3(0.3, 0.1, 0),
          new Vector3(0, 0, -Math.PI / 18), Doubles.EMPTY),
      STAMPED);
  private static final Sample SCAN = new Sample("laser",
      new LaserScan(new FrameId("robby", "laser"), -Math.PI / 2, Math.PI / 4, 0.1, 8, 0,
          Floats.of(1.5f, Float.POSITIVE_INFINITY, 2.5f, 3), Floats.EMPTY),
      STAMPED);

  private final List<Data> heard = new CopyOnWriteArrayList<>();
  private final YarpCarrier carrier;
  private final Gate names;
  private final Map<String, Gate> gates = new LinkedHashMap<>();
  private final Map<String, YarpPort> ports = new LinkedHashMap<>();
  private Optional<NameServer> server = Optional.empty();
  private volatile boolean hangs;

  YarpPeer(YarpCarrier carrier) {
    this.carrier = carrier;
    try {
      names = new Gate();
      for (String name : List.of(ODOMETRY, LASER, VELOCITY, RPC)) {
        gates.put(name, new Gate());
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
    return YarpSessions.rfic(context,
        settings(Map.of("host", "127.0.0.1", "port", (long) names.port(), "carrier", carrier.word())));
  }

  static YarpSettings settings(Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    YarpSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    return YarpSettings.of(new Settings(YarpSettings.SCHEMA, values), Map.of());
  }

  @Override
  public void start() throws IOException {
    NameServer opened = new NameServer(InetAddress.getLoopbackAddress(), 0, THREADS);
    server = Optional.of(opened);
    NameClient client = new NameClient(new HostPort("127.0.0.1", opened.port()), SocketFactory.getDefault(),
        PortOptions.of(THREADS).patience());
    for (Map.Entry<String, Gate> each : gates.entrySet()) {
      YarpPort port = new YarpPort(each.getKey(), InetAddress.getLoopbackAddress(), 0, Optional.of(client), this::hear,
          PortOptions.of(THREADS));
      ports.put(each.getKey(), port);
      each.getValue().open(port.port());
      opened.register(each.getKey(), new HostPort("127.0.0.1", each.getValue().port()));
    }
    names.open(opened.port());
  }

  private Optional<Bottle> hear(PortArrival arrival) {
    if (arrival.bottle().size() == 3) {
      double[] said = arrival.bottle().numbers();
      heard.add(new VelocityCommand(new Vector3(said[0], said[1], 0), new Vector3(0, 0, Math.toRadians(said[2]))));
    }
    return Optional.empty();
  }

  @Override
  public void kill() {
    names.shut();
    gates.values().forEach(Gate::shut);
    ports.values().forEach(YarpPort::close);
    ports.clear();
    server.ifPresent(NameServer::close);
    server = Optional.empty();
  }

  @Override
  public void hang() {
    hangs = true;
    names.hold();
    gates.values().forEach(Gate::hold);
  }

  @Override
  public void goOn() {
    hangs = false;
    names.goOn();
    gates.values().forEach(Gate::goOn);
  }

  /** A scan that is none, and bytes that are no message, in the name of the scanner. */
  @Override
  public void garble() throws IOException {
    say(LASER, Bottle.of("a", "b"));
    YarpAddress ours =
        server.orElseThrow().ports().stream().filter(a -> a.name().startsWith("/robotui/")).findFirst().orElseThrow();
    byte[] garbage = new byte[256];
    Arrays.fill(garbage, (byte) 0xff);
    try (Socket socket = new Socket(ours.where().host(), ours.where().port())) {
      socket.getOutputStream().write(YarpFraming.bytes(new YarpFraming.Header(YarpCarrier.FAST_TCP, LASER)));
      socket.getOutputStream().write(garbage);
    }
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public void say(Sample sample) {
    if (sample.equals(POSE)) {
      say(ODOMETRY, Bottle.reals(1, -2, 90, 0.3, 0.1, -10, 0, 0, 0));
    } else {
      say(LASER, Bottle.of(-90.0, 90.0, 0.1, 8.0, List.of(1.5, Double.POSITIVE_INFINITY, 2.5, 3.0), 1));
    }
  }

  private void say(String name, Bottle bottle) {
    YarpPort port = ports.get(name);
    if (port != null && !hangs) {
      port.say(bottle, Optional.of(STAMP));
    }
  }

  @Override
  public int listeners(Sample sample) {
    YarpPort port = ports.get(sample.equals(POSE) ? ODOMETRY : LASER);
    return port == null ? 0 : port.targets().size();
  }

  @Override
  public String motionPort() {
    return "base/velocity";
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
    return server.map(NameServer::ports).orElse(List.of()).stream().map(YarpAddress::name)
        .filter(name -> name.startsWith("/robotui")).collect(Collectors.toSet());
  }

  @Override
  public int links() {
    return names.links() + gates.values().stream().mapToInt(Gate::links).sum()
        + ports.values().stream().mapToInt(port -> port.targets().size()).sum();
  }

  @Override
  public void close() {
    kill();
    names.close();
    gates.values().forEach(Gate::close);
  }
}
