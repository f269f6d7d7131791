package org.robotui.rfic.roblets.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashMap;
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
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.GpsFix;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.roblets.brain.Brain;
import org.robotui.roblets.brain.BrainOptions;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.wire.RobletForm;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.DatagramGate;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.Sample;

/** A body of two roblets with a brain, behind a gate. */
final class RobletsPeer implements Peer {
  static final RobletForm BASE = new RobletForm("base", 20, List.of(new BodyForm("motion", "odometry", List.of())),
      List.of(new BodyForm("velocity", "velocity", List.of())), List.of());
  static final RobletForm GPS = new RobletForm("gps", 5, List.of(new BodyForm("position", "gpsfix", List.of())),
      List.of(), List.of());
  private static final long NANOS = 1_700_000_000_000_000_000L;
  private static final Optional<Stamp> STAMPED = Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT));
  private static final FrameId BODY = new FrameId("robby", "base_link");
  private static final Sample POSE = new Sample("base/motion", new Odometry(new FrameId("robby", "odom"), BODY,
      RigidTransform.planar(1, -2, Math.PI / 2), Doubles.EMPTY, new Vector3(0.3, 0.1, 0), new Vector3(0, 0, -0.25),
      Doubles.EMPTY), STAMPED);
  private static final Sample FIX = new Sample("gps/position", new GpsFix(BODY, GpsFix.Quality.FIX,
      Math.toRadians(43.7), Math.toRadians(-10.4), 12.5, Double.NaN), STAMPED);
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final List<Data> heard = new CopyOnWriteArrayList<>();
  private final DatagramGate gate;
  private final Map<String, BareRoblet> roblets = new LinkedHashMap<>();
  private Optional<Brain> brain = Optional.empty();

  RobletsPeer() {
    try {
      gate = new DatagramGate();
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
    return RobletsSessions.rfic(context, settings(gate.port()));
  }

  static RobletsSettings settings(int port) {
    Map<String, Object> values = new HashMap<>();
    RobletsSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(Map.of("host", "127.0.0.1", "port", (long) port));
    return RobletsSettings.of(new Settings(RobletsSettings.SCHEMA, values), Map.of());
  }

  @Override
  public void start() throws IOException {
    Brain opened = new Brain(BrainOptions.loopback(THREADS, 0, "robby"));
    brain = Optional.of(opened);
    roblets.put("base", new BareRoblet(BASE, opened.port(), this::hear));
    roblets.put("gps", new BareRoblet(GPS, opened.port(), message -> {}));
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (opened.roblets().size() < 2 && System.nanoTime() < end) {
      LockSupport.parkNanos(1_000_000);
    }
    gate.open(new InetSocketAddress(InetAddress.getLoopbackAddress(), opened.port()));
  }

  private void hear(BodyElement said) {
    heard.add(new VelocityCommand(new Vector3(said.needed("vx"), said.needed("vy"), 0),
        new Vector3(0, 0, said.needed("wz"))));
  }

  @Override
  public void kill() {
    gate.shut();
    roblets.values().forEach(BareRoblet::close);
    roblets.clear();
    brain.ifPresent(Brain::close);
    brain = Optional.empty();
  }

  @Override
  public void hang() {
    gate.hold();
  }

  @Override
  public void goOn() {
    gate.goOn();
  }

  /** Bytes that are no message, and a position that is none. */
  @Override
  public void garble() throws IOException {
    gate.inject("<r4n kind='message' from='gps'".getBytes(StandardCharsets.UTF_8));
    roblets.get("gps").say(BodyElement.of("position").with("latitude", "north"), NANOS);
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, FIX);
  }

  @Override
  public void say(Sample sample) throws IOException {
    String roblet = sample.equals(POSE) ? "base" : "gps";
    BareRoblet speaker = roblets.get(roblet);
    if (speaker != null && !gate.holds()) {
      speaker.say(sample.equals(POSE)
          ? BodyElement.of("motion").with("x", 1).with("y", -2.0).with("yaw", Math.PI / 2).with("vx", 0.3)
              .with("vy", 0.1).with("wz", -0.25)
          : BodyElement.of("position").with("latitude", 43.7).with("longitude", -10.4).with("altitude", 12.5), NANOS);
    }
  }

  @Override
  public int listeners(Sample sample) {
    return brain.map(b -> b.watchersOf(sample.equals(POSE) ? "base" : "gps")).orElse(0);
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
    return brain.map(Brain::watchers).orElse(Set.of());
  }

  @Override
  public int links() {
    return registrations().size();
  }

  @Override
  public void close() {
    kill();
    gate.close();
  }
}
