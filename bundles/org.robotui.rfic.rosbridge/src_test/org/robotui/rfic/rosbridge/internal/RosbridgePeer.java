package org.robotui.rfic.rosbridge.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
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
import org.robotui.message.Generation;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.payload.RosFormat;
import org.robotui.testkit.rfic.GatedPeer;
import org.robotui.testkit.rfic.Sample;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** A base with a laser behind a bridge, which is behind a gate(). */
final class RosbridgePeer extends GatedPeer {
  private static final Stamp STAMP = Stamp.of(1_700_000_000L, 500, ClockKind.ROBOT);
  private static final Sample POSE = new Sample("odom",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"),
          new RigidTransform(new Vector3(1, -2, 3), Quaternion.fromYaw(0.5)), Doubles.wrap(new double[36]),
          new Vector3(0.3, 0.1, 0.2), new Vector3(0.4, 0.5, -0.2), Doubles.wrap(new double[36])),
      Optional.of(STAMP));
  private static final Sample SCAN = new Sample("scan",
      new LaserScan(new FrameId("robby", "laser"), -1, 1, 0.5, 30, 0, Floats.of(1, 2, 3), Floats.EMPTY),
      Optional.of(STAMP));
  private static final VelocityCommand MOTION =
      new VelocityCommand(new Vector3(0.3, 0.1, 0.2), new Vector3(0.4, 0.5, -0.2));

  private final Generation generation;
  private final String compression;
  private final RosDefinitions definitions = new RosDefinitions(Map.of());
  private Optional<RosbridgeServer> server = Optional.empty();

  RosbridgePeer(Generation generation, String compression) {
    this.generation = generation;
    this.compression = compression;
  }

  @Override
  public Rfic create(RficContext context) {
    return rfic(context, Map.of("url", "ws://127.0.0.1:" + port(), "compression", compression));
  }

  static Rfic rfic(RficContext context, Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    RosbridgeSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    return new RosbridgeRficType().create(context, new Settings(RosbridgeSettings.SCHEMA, values));
  }

  @Override
  public void start() throws IOException {
    RosbridgeServer opened = new RosbridgeServer(generation);
    server = Optional.of(opened);
    gate().open(opened.port());
  }

  @Override
  public void kill() {
    gate().shut();
    take();
    server.ifPresent(RosbridgeServer::close);
    server = Optional.empty();
  }

  @Override
  public void garble() {
    RosbridgeServer there = server.orElseThrow();
    there.tell("{\"op\":");
    for (String topic : List.of("/odom", "/scan")) {
      there.publish(topic, Map.of("nonsense", 1), ByteBuffer.wrap(new byte[]{0, 1, 0, 0, 7}));
    }
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public void say(Sample sample) {
    boolean pose = sample.equals(POSE);
    Map<String, Object> fields = pose ? pose() : scan();
    PayloadFormat format = new RosFormat(definitions.find(type(pose ? "nav_msgs/Odometry" : "sensor_msgs/LaserScan"))
        .orElseThrow(), generation.encoding());
    server.ifPresent(there -> there.publish("/" + sample.port(), fields, format.write(fields)));
  }

  private String type(String plain) {
    return generation == Generation.ROS2 ? plain.replace("/", "/msg/") : plain;
  }

  private Map<String, Object> header(String frame) {
    return Map.of("stamp", generation == Generation.ROS2 ? Map.of("sec", 1_700_000_000, "nanosec", 500)
        : Map.of("secs", 1_700_000_000, "nsecs", 500), "frame_id", frame);
  }

  private Map<String, Object> pose() {
    Map<String, Object> place = Map.of("position", vector(1, -2, 3), "orientation",
        Map.of("x", 0, "y", 0, "z", Math.sin(0.25), "w", Math.cos(0.25)));
    Map<String, Object> twist = Map.of("linear", vector(0.3, 0.1, 0.2), "angular", vector(0.4, 0.5, -0.2));
    return Map.of("header", header("odom"), "child_frame_id", "base_link", "pose", Map.of("pose", place), "twist",
        Map.of("twist", twist));
  }

  private Map<String, Object> scan() {
    return Map.of("header", header("laser"), "angle_min", -1, "angle_max", 1, "angle_increment", 1, "range_min", 0.5,
        "range_max", 30, "ranges", List.of(1, 2, 3));
  }

  private static Map<String, Object> vector(double x, double y, double z) {
    return Map.of("x", x, "y", y, "z", z);
  }

  @Override
  public int listeners(Sample sample) {
    return server.map(there -> (int) there.subscriptions.stream()
        .filter(each -> each.topic().equals("/" + sample.port())).count()).orElse(0);
  }

  @Override
  public String motionPort() {
    return "cmd_vel";
  }

  @Override
  public Motion<?> motion() {
    return MOTION;
  }

  @Override
  public List<Data> heard() {
    take();
    return super.heard();
  }

  /** What this bridge heard since it was asked. */
  private void take() {
    server.ifPresent(there -> {
      for (Map<String, Object> each = there.said.poll(); each != null; each = there.said.poll()) {
        hears(velocity(each));
      }
    });
  }

  private static VelocityCommand velocity(Map<String, Object> twist) {
    try {
      return new VelocityCommand(vector(Trees.object(twist.get("linear"))), vector(Trees.object(twist.get("angular"))));
    } catch (TreeException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Vector3 vector(Map<String, Object> v) {
    double[] all = List.of("x", "y", "z").stream().mapToDouble(axis -> ((Number) v.get(axis)).doubleValue()).toArray();
    return new Vector3(all[0], all[1], all[2]);
  }

  @Override
  public Set<String> registrations() {
    RosbridgeServer there = server.orElseThrow();
    Set<String> all = new TreeSet<>();
    there.advertised.keySet().forEach(each -> all.add("publishes" + each.substring(each.indexOf(' '))));
    there.subscriptions.forEach(each -> all.add("subscribes " + each.topic()));
    return all;
  }
}
