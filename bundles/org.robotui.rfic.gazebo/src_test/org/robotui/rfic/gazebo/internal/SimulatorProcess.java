package org.robotui.rfic.gazebo.internal;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.gazebo.GazeboNode;
import org.robotui.gazebo.GazeboOptions;
import org.robotui.gazebo.GazeboPublisher;
import org.robotui.gazebo.types.GazeboTypes;
import org.robotui.message.payload.protobuf.ProtobufFormat;

/** A simulated base in a process of its own, which does what it reads and says what it hears. */
final class SimulatorProcess {
  static final long STAMP = 1_700_000_000_250_000_000L;
  private static final String TWIST = "gz.msgs.Twist";
  private static final GazeboTypes TYPES = GazeboTypes.of(Map.of());

  private final GazeboNode node;
  private final Map<String, GazeboPublisher> publishers = new HashMap<>();

  private SimulatorProcess(GazeboNode node) {
    this.node = node;
    publishers.put("odom", node.advertise("/odom", "gz.msgs.Odometry"));
    publishers.put("scan", node.advertise("/scan", "gz.msgs.LaserScan"));
    node.subscribe("/cmd_vel", TWIST, 1000, (sender, payload, nanos) -> heard(payload));
  }

  public static void main(String[] args) throws IOException {
    GazeboOptions options = GazeboOptions.of(Map.of("GZ_PARTITION", args[0]), Thread::new);
    try (GazeboNode node = GazeboNode.open(options, reason -> {});
        BufferedReader orders = new BufferedReader(new InputStreamReader(System.in))) {
      SimulatorProcess process = new SimulatorProcess(node);
      say("= ready");
      for (String line = orders.readLine(); line != null; line = orders.readLine()) {
        process.obey(line.split(" "));
      }
    }
    System.exit(0);
  }

  private static synchronized void say(String line) {
    System.out.println(line);
    System.out.flush();
  }

  private void obey(String... words) {
    switch (words[0]) {
      case "odom" -> publishers.get("odom").publish(bytes("gz.msgs.Odometry", odometry()));
      case "scan" -> publishers.get("scan").publish(bytes("gz.msgs.LaserScan", scan()));
      case "nonsense" -> publishers.values().forEach(each -> each.publish(new byte[]{0x0a, 0x7f, 1}));
      case "listeners" -> say("= " + publishers.get(words[1]).subscribers());
      case "graph" -> say("= " + Stream.concat(node.graph().topics().stream(), node.graph().subscriptions().stream())
          .map(each -> each.name().name() + " of " + each.process()).sorted().collect(Collectors.joining(";")));
      case "links" -> say("= " + node.graph().processes().size());
      default -> throw new IllegalArgumentException(words[0]);
    }
  }

  private static byte[] bytes(String type, Map<String, Object> fields) {
    ByteBuffer written = new ProtobufFormat(TYPES.find(type).orElseThrow()).write(fields);
    byte[] bytes = new byte[written.remaining()];
    written.get(bytes);
    return bytes;
  }

  private static Map<String, Object> header(String... frames) {
    List<Map<String, Object>> data = Stream.iterate(0, i -> i + 2).limit(frames.length / 2)
        .map(i -> Map.<String, Object>of("key", frames[i], "value", List.of(frames[i + 1]))).toList();
    return Map.of("stamp", Map.of("sec", STAMP / 1_000_000_000, "nsec", STAMP % 1_000_000_000), "data", data);
  }

  private static Map<String, Object> odometry() {
    return Map.of("header", header("frame_id", "odom", "child_frame_id", "base_link"),
        "pose", Map.of("position", vector(2, -1, 0.5), "orientation",
            Map.of("z", Math.sin(0.1), "w", Math.cos(0.1))),
        "twist", Map.of("linear", vector(0.2, 0.3, 0.4), "angular", vector(-0.1, -0.2, 0.6)));
  }

  private static Map<String, Object> scan() {
    return Map.of("header", header(), "frame", "laser", "angle_min", -1, "angle_max", 1, "angle_step", 1, "range_min",
        0.1, "range_max", 30, "count", 3, "ranges", List.of(1, "NaN", "Infinity"));
  }

  private static Map<String, Object> vector(double x, double y, double z) {
    return Map.of("x", x, "y", y, "z", z);
  }

  private static void heard(ByteBuffer payload) {
    DynamicRecord twist = new ProtobufFormat(TYPES.find(TWIST).orElseThrow()).read(payload);
    say("heard " + Stream.of("linear.x", "linear.y", "linear.z", "angular.x", "angular.y", "angular.z")
        .map(path -> twist.at(FieldPath.parse(path)).map(v -> ((FieldValue.Num) v).value()).orElse(0.0))
        .map(String::valueOf).collect(Collectors.joining(" ")));
  }
}
