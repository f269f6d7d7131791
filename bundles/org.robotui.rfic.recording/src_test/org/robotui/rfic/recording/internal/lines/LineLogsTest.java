package org.robotui.rfic.recording.internal.lines;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.message.Generation;
import org.robotui.message.MessageException;
import org.robotui.message.RecordBinding;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.sensor_msgs.Range;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.ScanProgress;
import org.robotui.rfic.recording.internal.file.RecordingFiles;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.recorded.SharedData;

/** Logs of CARMEN and Player as recordings. */
class LineLogsTest {
  @TempDir
  private Path folder;

  @Test
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void of_carmen_have_what_the_bag_of_the_same_drive_has() throws IOException {
    try (RecordingReader log = open(SharedData.file("carmen/sena_loop.log"));
        RecordingReader bag = open(SharedData.file("bags/sena_loop.bag"))) {
      assertEquals("CARMEN log", log.format());
      assertEquals(List.of(), log.damages());
      List<RecordedMessage> scans = of(log, "/robot_frontlaser");
      List<RecordedMessage> places = of(log, "/base_odometry");
      List<RecordedMessage> bagScans = of(bag, "/scan");
      List<RecordedMessage> bagPlaces = of(bag, "/odom");
      assertEquals(224, scans.size());
      assertEquals(224, places.size());
      for (int i = 0; i < 224; i++) {
        assertEquals(bagScans.get(i).logTime(), scans.get(i).logTime(), 2000);
        LaserScan expected = read(bagScans.get(i), LaserScan.class);
        LaserScan scan = read(scans.get(i), LaserScan.class);
        assertEquals(expected.angleMin(), scan.angleMin(), 1e-4);
        assertEquals(expected.angleIncrement(), scan.angleIncrement(), 1e-6);
        for (int k = 0; k < 361; k++) {
          assertEquals(Math.min(expected.ranges()[k], 80), Math.min(scan.ranges()[k], 80), 0.0051, i + ", " + k);
        }
        Point where = read(bagPlaces.get(i), Odometry.class).pose().pose().position();
        Point place = read(places.get(i), Odometry.class).pose().pose().position();
        assertEquals(where.x(), place.x(), 1e-5);
        assertEquals(where.y(), place.y(), 1e-5);
      }
      TransformStamped mount = transforms(log).get("robot_frontlaser");
      assertEquals("base_link", mount.header().frameId());
      assertEquals(0.78, mount.transform().translation().x(), 1e-6);
    }
  }

  @Test
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void that_are_compressed_are_read_and_told_where_they_are_cut_off() throws IOException {
    Path plain = SharedData.file("carmen/sena_loop.log");
    Path packed = folder.resolve("sena.log.gz");
    try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(packed))) {
      Files.copy(plain, out);
    }
    try (RecordingReader log = open(packed); RecordingReader same = open(plain)) {
      assertEquals(List.of(), log.damages());
      assertEquals(packed, log.file());
      assertEquals(same.messageCounts(), log.messageCounts());
      assertEquals(of(same, "/robot_frontlaser").getLast().data(), of(log, "/robot_frontlaser").getLast().data());
    }
    byte[] all = Files.readAllBytes(packed);
    Files.write(packed, Arrays.copyOf(all, all.length / 2));
    try (RecordingReader log = open(packed)) {
      assertTrue(log.damages().toString().contains("cannot be decompressed"), log.damages().toString());
      assertTrue(of(log, "/robot_frontlaser").size() > 50);
    }
    Files.write(packed, Arrays.copyOf(all, 5));
    assertFalse(LineLogs.isOne(packed));
  }

  @Test
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void of_carmen_have_every_line_of_the_recorded_session() throws IOException {
    Path file = SharedData.file("../captures/carmen/carmen.log");
    Map<String, Long> lines = Files.readAllLines(file).stream().filter(line -> !line.startsWith("#"))
        .collect(Collectors.groupingBy(line -> line.split(" ")[0], Collectors.counting()));
    try (RecordingReader log = open(file)) {
      assertEquals(List.of(), log.damages());
      assertEquals(lines.get("PARAM"), of(log, "/param").size());
      assertEquals(lines.get("ODOM"), of(log, "/base_odometry").size());
      assertEquals(lines.get("RAWLASER1"), of(log, "/laser_laser1").size());
      assertEquals(lines.get("ROBOTLASER1"), of(log, "/robot_frontlaser").size());
      assertEquals(lines.get("TRUEPOS"), of(log, "/simulator_truepos").size());
      assertEquals(lines.get("SONAR") * 7, of(log, "/base_sonar").size());
      assertEquals("{\"name\":\"robot_turn_before_driving_if_heading_bigger_than\",\"value\":\"1.5708\"}",
          of(log, "/param").stream().map(LineLogsTest::text).filter(text -> text.contains("turn_before")).findFirst()
              .orElseThrow().replaceAll("\\{(\"value\":.*),(\"name\":.*)}", "{$2,$1}"));
      // what is known of the end of that session
      Point last = read(of(log, "/localize_globalpos").getLast(), PoseWithCovarianceStamped.class).pose().pose()
          .position();
      assertEquals(30.437, last.x(), 1e-3);
      assertEquals(8.634, last.y(), 1e-3);
      assertEquals(0.5236, read(of(log, "/base_sonar").getFirst(), Range.class).fieldOfView(), 1e-6);
      assertEquals(1795235713_758000000L, of(log, "/base_odometry").getFirst().publishTime());
      assertEquals(1795235713_719476000L + 37_987_000L, of(log, "/base_odometry").getFirst().logTime(), 50_000);
      assertEquals(Set.of("base_link", "odom", "robot_frontlaser", "sonar_0", "sonar_1", "sonar_2", "sonar_3",
          "sonar_4", "sonar_5", "sonar_6"), transforms(log).keySet());
    }
  }

  @Test
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void of_player_have_the_way_and_the_scans() throws IOException {
    try (RecordingReader log = open(SharedData.file("../captures/player/stage.log"))) {
      assertEquals("Player log", log.format());
      assertEquals(List.of(), log.damages());
      assertEquals(450, of(log, "/position2d:0").size());
      assertEquals(1, of(log, "/position2d:0/ack_1").size());
      List<RecordedMessage> scans = of(log, "/laser:0");
      assertEquals(68, scans.size());
      LaserScan scan = read(scans.getFirst(), LaserScan.class);
      assertEquals("laser_0", scan.header().frameId());
      assertEquals(180, scan.ranges().length);
      assertEquals(-1.5708, scan.angleMin(), 1e-6);
      assertArrayEquals(new float[]{5.845f, 6.183f, 6.550f}, Arrays.copyOf(scan.ranges(), 3));
      assertEquals(Float.POSITIVE_INFINITY, scan.ranges()[5], "eight metres are as far as it sees");
      assertEquals(1, scan.intensities()[20]);
      Odometry first = read(of(log, "/position2d:0").getFirst(), Odometry.class);
      assertEquals(25_110_000_000L, first.header().stamp());
      assertEquals(0.339, first.pose().pose().position().x(), 1e-9);
      assertTrue(transforms(log).keySet().containsAll(Set.of("base_link", "laser_0")));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"FLASER 3 1 2", "FLASER 9999999 1 2 3 1.5 host 2", "FLASER -1 1 1.5 host 2", "ODOM 1 2",
      "ODOM 1 2 x 0 0 0 1 host 1", "ODOM 1 2 NaN 0 0 0 1 host 1", "ODOM 1 2 3 0 0 0 1 host 1e300",
      "ODOM 1 2 3 0 0 0 1 host -5", "UNKNOWN 1 1 host 1", "RAWLASER1 3 0 0 0 0 0 0 2 1 1 host 1", "PARAM", "ODOM",
      "SONAR 0.5 1 3 0 0 1 host 1"})
  void tell_a_line_that_cannot_be_read_and_read_the_others(String line) throws IOException {
    String good = "ODOM 1 2 0.5 0.1 0 0 1500000000.25 host 1500000000.5\n";
    try (RecordingReader log = open(written("a.log", good + line + "\n" + good))) {
      assertEquals(2, of(log, "/base_odometry").size());
      assertEquals(1, log.damages().size(), log.damages().toString());
      assertEquals(good.length(), log.damages().getFirst().offset());
    }
  }

  @Test
  void are_read_in_pieces_of_any_size() throws IOException {
    StringBuilder text = new StringBuilder("# CARMEN Logfile\n");
    for (int i = 0; i < 40_000; i++) {
      text.append("ODOM ").append(i).append(" 0 0 0 0 0 ").append(1_500_000_000 + i).append(".25 host ").append(i)
          .append('\n');
      if (i == 20_000) {
        text.append("x".repeat(3 << 20)).append('\n');
      }
    }
    try (RecordingReader log = open(written("long.log", text.toString()))) {
      List<RecordedMessage> places = of(log, "/base_odometry");
      assertEquals(40_000, places.size());
      for (int i = 0; i < places.size(); i += 999) {
        assertEquals(i, read(places.get(i), Odometry.class).pose().pose().position().x());
        assertEquals((1_500_000_000L + i) * 1_000_000_000 + 250_000_000, places.get(i).logTime());
      }
      assertFalse(log.damages().isEmpty());
      assertTrue(log.damages().toString().length() < 2000, "no megabytes of what is wrong");
    }
  }

  @Test
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void survive_all_that_may_be_in_a_file() throws IOException {
    for (String name : List.of("../captures/carmen/carmen.log", "../captures/player/stage.log")) {
      byte[] whole = Files.readAllBytes(SharedData.file(name));
      byte[] part = Arrays.copyOf(whole, Math.min(whole.length, 20_000));
      ByteMutator mutator = new ByteMutator(7);
      for (int i = 0; i < 25; i++) {
        byte[] bytes = mutator.mutate(part);
        Path file = folder.resolve("mutated.log");
        Files.write(file, bytes);
        if (LineLogs.isOne(file)) {
          try (RecordingReader log = LineLogs.open(file, ScanProgress.NONE)) {
            all(log);
          }
        }
      }
    }
  }

  @Test
  void are_known_by_what_they_begin_with() throws IOException {
    assertFalse(RecordingFiles.isOne(written("other.log", "2026-11-28 10:00:00 INFO started\n")));
    assertFalse(RecordingFiles.isOne(written("empty.log", "")));
    assertFalse(RecordingFiles.isOne(written("word.log", "ODOM is a word\n")));
    assertTrue(RecordingFiles.isOne(written("bare.log", "ODOM 0 0 0 0 0 0 1.5 nohost 1.5\n")));
  }

  private Path written(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.writeString(file, text, StandardCharsets.ISO_8859_1);
    return file;
  }

  private static RecordingReader open(Path file) throws IOException {
    return RecordingFiles.open(file, List.of(), ScanProgress.NONE);
  }

  private static List<RecordedMessage> of(RecordingReader recording, String topic) throws RecordingException {
    return all(recording).stream().filter(each -> each.channel().topic().equals(topic)).toList();
  }

  private static List<RecordedMessage> all(RecordingReader recording) throws RecordingException {
    List<RecordedMessage> all = new ArrayList<>();
    RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      all.add(next.get());
    }
    return all;
  }

  private static String text(RecordedMessage message) {
    return StandardCharsets.UTF_8.decode(message.data().duplicate()).toString();
  }

  /** By the frame that they place. */
  private static Map<String, TransformStamped> transforms(RecordingReader recording) throws RecordingException {
    return of(recording, "/tf").stream().map(each -> read(each, TFMessage.class).transforms().getFirst())
        .collect(Collectors.toMap(TransformStamped::childFrameId, each -> each, (a, b) -> b));
  }

  private static <M extends Record> M read(RecordedMessage message, Class<M> type) {
    try {
      return RecordBinding.shipped(type, Generation.ROS1).decode(message.data().duplicate());
    } catch (MessageException e) {
      throw new AssertionError(message.channel().topic(), e);
    }
  }
}
