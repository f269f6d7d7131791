package org.robotui.rfic.carmen.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.config.Settings;
import org.robotui.carmen.central.CentralOptions;
import org.robotui.carmen.central.IpcCentral;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.MessageSender;
import org.robotui.carmen.module.ModuleOptions;
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
import org.robotui.guard.Guards;
import org.robotui.net.socket.HostPort;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.Gate;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.Sample;

/** A robot of CARMEN: a central of ours behind a gate, and one module that says and hears all. */
final class CarmenPeer implements Peer {
  private static final IpcForms FORMS = IpcForms.carmen();
  private static final double STAMP = 1.7e9;
  private static final Optional<Stamp> STAMPED = Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT));
  private static final Sample POSE = new Sample("base_odometry",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"), RigidTransform.planar(1, -2, 0.5),
          Doubles.EMPTY, new Vector3(0.3, 0, 0), new Vector3(0, 0, -0.2), Doubles.EMPTY),
      STAMPED);
  private static final Sample SCAN = new Sample("robot_frontlaser",
      new LaserScan(new FrameId("robby", "robot_frontlaser"), -1, 1, 0, 8, 0,
          Floats.of(1.5f, Float.POSITIVE_INFINITY, 2.5f), Floats.of(1, 2, 200)),
      STAMPED);
  private static final Map<Sample, String> MESSAGES =
      Map.of(POSE, "carmen_base_odometry", SCAN, "carmen_robot_frontlaser");

  private final List<Data> heard = new CopyOnWriteArrayList<>();
  private final Gate gate;
  private final boolean guard;
  private final boolean direct;
  private Optional<IpcCentral> central = Optional.empty();
  private Optional<IpcModule> robot = Optional.empty();
  private final Map<Sample, MessageSender> senders = new HashMap<>();

  CarmenPeer(boolean guard, boolean direct) {
    this.guard = guard;
    this.direct = direct;
    try {
      gate = new Gate();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public Map<Capability, String> lacks() {
    return direct ? Map.of(Capability.HANG, "the gate is before the central, and modules talk to each other",
        Capability.LINKS, "only links to the central are counted") : Map.of();
  }

  @Override
  public Rfic create(RficContext context) {
    return CarmenSessions.rfic(context, settings(Map.of("host", "127.0.0.1", "port", (long) gate.port(), "guard",
        guard)), new Guards());
  }

  static CarmenSettings settings(Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    CarmenSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    return CarmenSettings.of(new Settings(CarmenSettings.SCHEMA, values), Map.of());
  }

  @Override
  public void start() throws IOException {
    IpcCentral opened = new IpcCentral(new CentralOptions(THREADS, InetAddress.getLoopbackAddress(), 0, direct));
    central = Optional.of(opened);
    IpcModule module = IpcModule.connect(new HostPort("127.0.0.1", opened.port()), FORMS,
        ModuleOptions.of("robot", THREADS));
    robot = Optional.of(module);
    module.subscribe(FORMS.get("carmen_robot_vel"), 1, (record, body) -> {
      heard.add(new VelocityCommand(new Vector3(record.number("tv"), 0, 0), new Vector3(0, 0, record.number("rv"))));
      return Optional.empty();
    });
    for (Sample sample : samples()) {
      senders.put(sample, module.sender(FORMS.get(MESSAGES.get(sample))));
    }
    gate.open(opened.port());
  }

  @Override
  public void kill() {
    gate.shut();
    senders.clear();
    robot.ifPresent(IpcModule::close);
    central.ifPresent(IpcCentral::close);
    robot = Optional.empty();
    central = Optional.empty();
  }

  @Override
  public void hang() {
    gate.hold();
  }

  @Override
  public void goOn() {
    gate.goOn();
  }

  @Override
  public void garble() throws IOException {
    publish(SCAN, scan(Double.NaN));
    byte[] garbage = new byte[256];
    Arrays.fill(garbage, (byte) 0xff);
    gate.inject(garbage);
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public void say(Sample sample) throws IOException {
    publish(sample, sample.equals(POSE)
        ? make(POSE).number("x", 1).number("y", -2).number("theta", 0.5).number("tv", 0.3).number("rv", -0.2).build()
        : scan(-1));
  }

  private void publish(Sample sample, IpcRecord record) throws IOException {
    MessageSender sender = senders.get(sample);
    if (sender != null) {
      sender.refresh();
      sender.publish(record);
    }
  }

  private static IpcRecordMaker make(Sample sample) {
    return FORMS.get(MESSAGES.get(sample)).make().number("timestamp", STAMP).text("host", "robot");
  }

  private static IpcRecord scan(double start) {
    return make(SCAN).floats("range", new float[]{1.5f, 8, 2.5f}).octets("tooclose", new byte[3])
        .floats("remission", new float[]{1, 2, 200}).struct("config", 3, start, 2, 1, 8, 0.01, 1)
        .struct("laser_pose", 1.2, -2, 0.5).struct("robot_pose", 1, -2, 0.5).build();
  }

  @Override
  public int listeners(Sample sample) {
    return (int) central.map(c -> c.handlers().getOrDefault(MESSAGES.get(sample), Set.of())).orElse(Set.of()).stream()
        .filter(name -> name.startsWith("robotui")).count();
  }

  @Override
  public String motionPort() {
    return "velocity";
  }

  @Override
  public Motion<?> motion() {
    return VelocityCommand.planar(0.3, -0.2);
  }

  @Override
  public List<Data> heard() {
    return List.copyOf(heard);
  }

  @Override
  public Set<String> registrations() {
    return central.map(IpcCentral::handlers).orElse(Map.of()).entrySet().stream()
        .filter(e -> e.getValue().stream().anyMatch(name -> name.startsWith("robotui")))
        .map(e -> e.getKey() + " is handled").collect(Collectors.toSet());
  }

  @Override
  public int links() {
    return gate.links();
  }

  @Override
  public void close() {
    kill();
    gate.close();
  }
}
