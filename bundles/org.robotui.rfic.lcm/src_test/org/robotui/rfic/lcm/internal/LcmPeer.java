package org.robotui.rfic.lcm.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
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
import org.robotui.guard.Guards;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.SubscriptionOptions;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.RecordException;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.convert.RecordFiller;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.Sample;

/** A base with a laser that speaks in types and units of its own. */
final class LcmPeer implements Peer {
  private static final String TYPES = """
      package tck;
      struct base_t { int64_t usec; int32_t pos[2]; float heading; float speed; float turn; }
      struct lidar_t { int64_t usec; int32_t n; int16_t mm[n]; }
      struct drive_t { float speed; float turn; }
      """;
  private static final Optional<Stamp> STAMPED = Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT));
  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final long USEC = 1_700_000_000_000_000L;
  private static final Sample POSE = new Sample("BASE",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"),
          RigidTransform.planar(1.5, -2.25, Math.PI / 6), Doubles.EMPTY, new Vector3(10, 0, 0),
          new Vector3(0, 0, Math.PI / 2), Doubles.EMPTY),
      STAMPED);
  private static final Sample SCAN =
      new Sample("LASER", new LaserScan(new FrameId("robby", "scanner"), -Math.PI / 2, Math.PI / 2, 0, 8, 0,
          Floats.of(1.5f, 0.25f, 2.5f), Floats.EMPTY), STAMPED);
  private static final Map<String, Map<String, Object>> CHANNELS = Map.of(
      "BASE",
      Written.map("as", "odometry", "x", "pos.0 mm", "y", "pos.1 mm", "yaw", "heading deg", "vx", "speed km/h", "wz",
          "turn deg/s", "stamp", "usec us",
          "frame", "odom", "child", "base_link"),
      "LASER",
      Written.map("as", "laserscan", "ranges", "mm mm", "angle_min", "-90 deg", "angle_max", "90 deg", "range_max",
          "8 m", "stamp", "usec us",
          "frame", "scanner"));
  private static final Map<String, Object> DRIVE =
      Written.map("as", "velocity", "type", "tck.drive_t", "vx", "speed mm/s", "wz", "turn deg/s");

  private final List<Data> heard = new CopyOnWriteArrayList<>();
  private final LcmBus bus;
  private final boolean guard;
  private final Path file;
  private final TypeLibrary types;
  private Optional<Lcm> robot = Optional.empty();

  LcmPeer(LcmBus bus, boolean guard) {
    this.bus = bus;
    this.guard = guard;
    try {
      file = Files.writeString(Files.createTempFile("tck", ".lcm"), TYPES);
      types = TypeFolder.read(List.of(file));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public Map<Capability, String> lacks() {
    Map<Capability, String> lacks = new EnumMap<>(Capability.class);
    lacks.put(Capability.DEMAND, "a client listens to all channels, as it learns what there is only by what is said");
    lacks.put(Capability.REGISTRATIONS, "LCM keeps no list of who is there");
    lacks.putAll(bus.lacks());
    return lacks;
  }

  @Override
  public Rfic create(RficContext context) {
    Settings settings = Written.settings(bus.url(), file.toString(), CHANNELS, Map.of("DRIVE", DRIVE));
    return LcmSessions.rfic(context, Written.right(Written.guarded(settings, guard)), new Guards());
  }

  @Override
  public void start() throws IOException {
    Lcm programs = Lcm.open(LcmUrl.of(bus.open()), LcmOptions.standard(THREADS));
    programs.subscribe("DRIVE", SubscriptionOptions.direct(), this::hear);
    robot = Optional.of(programs);
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!(programs.state() instanceof LcmState.Connected) && System.nanoTime() < end) {
      LockSupport.parkNanos(1_000_000);
    }
  }

  private void hear(LcmMessage message) {
    if (bus.holds()) {
      return;
    }
    try {
      LcmRecord drive = types.decode(message.data());
      heard.add(VelocityCommand.planar(drive.number("speed").orElseThrow() / 1000,
          Math.toRadians(drive.number("turn").orElseThrow())));
    } catch (RecordException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public void kill() {
    robot.ifPresent(Lcm::close);
    robot = Optional.empty();
    bus.shut();
  }

  @Override
  public void hang() {
    bus.hold();
  }

  @Override
  public void goOn() {
    bus.goOn();
  }

  @Override
  public void garble() throws IOException {
    byte[] whole = new byte[encoded(SCAN).remaining()];
    encoded(SCAN).get(whole);
    robot.orElseThrow().publish(SCAN.port(), ByteBuffer.wrap(whole, 0, whole.length - 3));
    byte[] garbage = new byte[256];
    Arrays.fill(garbage, (byte) 0xff);
    bus.inject(garbage);
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public void say(Sample sample) throws IOException {
    Optional<Lcm> speaking = robot.filter(r -> !bus.holds() && r.state() instanceof LcmState.Connected);
    if (speaking.isPresent()) {
      speaking.get().publish(sample.port(), encoded(sample));
    }
  }

  private ByteBuffer encoded(Sample sample) {
    Map<String, Object> fields = sample.equals(POSE)
        ? Map.of("usec", USEC, "pos", List.of(1500, -2250), "heading", 30, "speed", 36, "turn", 90)
        : Map.of("usec", USEC, "mm", List.of(1500, 250, 2500));
    LcmType type = types.type(sample.equals(POSE) ? "tck.base_t" : "tck.lidar_t").orElseThrow();
    return type.encode(new RecordFiller(types).fill(type, fields));
  }

  @Override
  public int listeners(Sample sample) {
    throw new UnsupportedOperationException("lacking");
  }

  @Override
  public String motionPort() {
    return "DRIVE";
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
    throw new UnsupportedOperationException("lacking");
  }

  @Override
  public int links() {
    return bus.links();
  }

  @Override
  public void close() {
    kill();
    bus.close();
    try {
      Files.delete(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
