package org.robotui.rfic.lcm.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.convert.RecordFiller;
import org.robotui.rfic.lcm.internal.session.SessionProbe;
import org.robotui.testkit.FakeRficContext;

/**
 * Messages and mappings that nobody means: whatever comes, it becomes a value or a complaint, and nothing else happens.
 */
class HostileMessagesTest {
  private static final int ROUNDS = 4000;
  private static final Map<String, String> CHANNELS =
      Map.ofEntries(Map.entry("odometry_t", "odometry"), Map.entry("pose_t", "pose"),
          Map.entry("transforms_t", "transforms"), Map.entry("laser_t", "laserscan"), Map.entry("ranges_t", "ranges"),
          Map.entry("imu_t", "imu"),
          Map.entry("battery_t", "battery"), Map.entry("image_t", "image"), Map.entry("map_t", "gridmap"),
          Map.entry("path_t", "path"), Map.entry("log_t", "log"));

  private static Map<String, Object> fields(String type) {
    return switch (type) {
      case "laser_t" -> Map.of("ranges", List.of(1, 2, 3), "angle_increment", 0.1, "range_max", 10, "frame", "laser");
      case "ranges_t" -> Map.of("ranges", List.of(1, 2), "x", List.of(1, 2), "y", List.of(1, 2), "z", List.of(1, 2),
          "yaw", List.of(1, 2), "range_max", 3);
      case "image_t" -> Map.of("encoding", "rgb8", "width", 1, "height", 1, "data", List.of(1, 2, 3));
      case "map_t" -> Map.of("resolution", 0.1, "cells", List.of(List.of(1, 2), List.of(3, 4)));
      case "path_t" -> Map.of("poses", List.of(Map.of("position", List.of(1, 2, 3)), Map.of()));
      case "transforms_t" -> Map.of("transforms", List.of(Map.of("parent", "a", "child", "b")));
      default -> Map.of("utime", 12);
    };
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void damagedMessagesBecomeValuesOrComplaints(long seed) throws Exception {
    TypeLibrary types = TypeFolder.read(List.of(Written.types()));
    FakeRficContext context = new FakeRficContext();
    Map<String, Object> channels = Written.map();
    CHANNELS.forEach(channels::put);
    LcmSettings settings = Written.right(Written.settings("memq://", Written.types().toString(), channels, Map.of()));
    Random random = new Random(seed);
    try (SessionProbe probe = new SessionProbe(context, settings, types)) {
      context.demands.values().forEach(d -> d.changed(true));
      List<String> names = CHANNELS.keySet().stream().sorted().toList();
      for (int i = 0; i < ROUNDS; i++) {
        String name = names.get(random.nextInt(names.size()));
        LcmType type = types.type("robotui." + name).orElseThrow();
        byte[] bytes = mutated(bytes(type.encode(new RecordFiller(types).fill(type, fields(name)))), random);
        probe.accept(new LcmMessage(name, ByteBuffer.wrap(bytes), "fuzz:1", System.nanoTime(), i));
      }
    }
    long values = context.published.values().stream().mapToLong(q -> q.size()).sum();
    long complaints = context.complaints.values().stream().mapToLong(q -> q.size()).sum();
    assertTrue(values > ROUNDS / 10 && complaints > ROUNDS / 20, values + " values, " + complaints + " complaints");
    context.published.values().forEach(q -> q.forEach(p -> {
      read(DataRecord.of(p.value()), 0);
      p.raw().flatMap(r -> r.record()).ifPresent(r -> read(r, 0));
    }));
  }

  private static byte[] bytes(ByteBuffer buffer) {
    byte[] bytes = new byte[buffer.remaining()];
    buffer.get(bytes);
    return bytes;
  }

  /** Leaves the fingerprint alone mostly, as else nothing is decoded. */
  private static byte[] mutated(byte[] bytes, Random random) {
    byte[] mutated = bytes.clone();
    int first = random.nextInt(20) == 0 ? 0 : Math.min(Long.BYTES, mutated.length - 1);
    for (int i = random.nextInt(4); i > 0; i--) {
      int at = first + random.nextInt(mutated.length - first);
      byte[] bad = {0, -1, 127, -128, (byte) random.nextInt()};
      mutated[at] = bad[random.nextInt(bad.length)];
    }
    return random.nextInt(4) == 0 ? Arrays.copyOf(mutated, random.nextInt(mutated.length + 20)) : mutated;
  }

  private static void read(DynamicRecord record, int depth) {
    Consumer<FieldValue> deeper = v -> {
      if (v instanceof FieldValue.Nested n && depth < 6) {
        read(n.value(), depth + 1);
      }
    };
    record.fields().forEach(f -> record.field(f).ifPresent(v -> {
      deeper.accept(v);
      if (v instanceof FieldValue.Items items) {
        items.values().forEach(deeper);
      }
    }));
  }

  @Test
  void mappingsOfRandomWordsAreRefusedWithTheirPlace() {
    Random random = new Random(5);
    String[] words = {"pos", "[0]", "[]", "position", ".", "x", "-", "mm", "deg", " ", "$", "utime", "us", "1e9", "0x",
        "*", "poses", "\u00e4", "[99999999999]", "as"};
    String[] fields = {"position", "x", "yaw", "frame", "stamp", "orientation", "linear", "child"};
    int refused = 0;
    for (int i = 0; i < ROUNDS; i++) {
      StringBuilder text = new StringBuilder();
      for (int n = 1 + random.nextInt(4); n > 0; n--) {
        text.append(words[random.nextInt(words.length)]);
      }
      var faults = new LcmRficType().faults(Written.settings("memq://",
          Written.types().toString() + "/robotui/odometry_t.lcm", Map.of("X",
              Written.map("as", "odometry", "type", "robotui.odometry_t", fields[random.nextInt(fields.length)],
                  text.toString())),
          Map.of()));
      faults.forEach(f -> assertTrue(f.toString().matches("(?s)robot.yaml:10:(5|11|12): .+"), f.toString()));
      refused += faults.isEmpty() ? 0 : 1;
    }
    assertTrue(refused > ROUNDS / 2 && refused < ROUNDS, refused + " of " + ROUNDS);
  }
}
