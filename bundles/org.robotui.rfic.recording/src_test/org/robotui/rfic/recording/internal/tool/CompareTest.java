package org.robotui.rfic.recording.internal.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.recording.RecordingException;
import org.robotui.rfic.recording.internal.SmallRecording;

/** What {@code log compare} says of two drives around a circle of 2 m. */
class CompareTest {
  private static final double LATER = 100;

  @TempDir
  private Path folder;
  private Path first;
  private Path second;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  /** The second one begins 100 s later, 1 m beside, is turned by a quarter, and wobbles by 2 cm. */
  @BeforeEach
  void record() throws RecordingException {
    first = folder.resolve("first.mcap");
    second = folder.resolve("second.mcap");
    try (SmallRecording one = new SmallRecording(first); SmallRecording other = new SmallRecording(second)) {
      for (int i = 0; i < 100; i++) {
        double angle = i * 0.05;
        drive(one, "/odom", i * 0.1, 2 * Math.cos(angle), 2 * Math.sin(angle), angle, 0.4);
        double wobble = i % 2 == 0 ? 0.02 : -0.02;
        drive(other, "/base", LATER + i * 0.1, 1 - (2 + wobble) * Math.sin(angle), (2 + wobble) * Math.cos(angle),
            angle + Math.PI / 2, 0.5 + wobble);
      }
    }
  }

  private static void drive(SmallRecording recording, String topic, double seconds, double x, double y, double yaw,
      double speed) throws RecordingException {
    recording.say(topic, SmallRecording.ODOMETRY, Map.of(), seconds, Map.of("header",
        SmallRecording.header(seconds, "odom"), "child_frame_id", "base_link", "pose",
        Map.of("pose", Map.of("position", Map.of("x", x, "y", y), "orientation",
            Map.of("z", Math.sin(yaw / 2), "w", Math.cos(yaw / 2)))),
        "twist", Map.of("twist", Map.of("linear", Map.of("x", speed)))));
  }

  @Test
  void tells_how_far_two_ways_are_apart() {
    assertEquals(0, compare("--topic", "odom,base", "--by", "start", "--align", "se3", "--json"), err::toString);
    assertEquals(0.02, figure("APE position", "rmse"), 1e-4);
    assertEquals(0.02, figure("APE position", "mean"), 1e-4);
    assertTrue(figure("APE rotation", "max") < 0.1);
    assertEquals(0.04, figure("RPE position per pose", "mean"), 0.001);
    assertTrue(out.toString().contains("\"pairs\":100,\"shift\":\"-100000000000\""), out.toString());
  }

  @Test
  void errors_over_time_and_way_are_those_of_the_table() throws Exception {
    Path csv = folder.resolve("ways.csv");
    assertEquals(0, compare("--topic", "odom,base", "--by", "start", "--csv", csv.toString(), "--json"),
        err::toString);
    List<String> lines = Files.readAllLines(csv);
    assertEquals("time [s],way [m],APE position [m],APE rotation [deg],RPE position per pose [m],"
        + "RPE rotation per pose [deg]", lines.getFirst());
    double[] position = lines.stream().skip(1).mapToDouble(line -> Double.parseDouble(line.split(",")[2])).toArray();
    assertEquals(Math.sqrt(Arrays.stream(position).map(each -> each * each).sum() / position.length),
        figure("APE position", "rmse"), 1e-9);
    double[] way = lines.stream().skip(1).mapToDouble(line -> Double.parseDouble(line.split(",")[1])).toArray();
    assertEquals(0, way[0]);
    assertTrue(way[way.length - 1] > way[1] && way[1] > 0, Arrays.toString(way));
  }

  @ParameterizedTest
  @CsvSource({"--offset, -100, 0", "--by, start, 0", "--align, none, 2"})
  void says_where_nothing_belongs_together(String option, String value, int code) {
    assertEquals(code, compare("--topic", "odom,base", option, value), err::toString);
    assertTrue(code == 0 || err.toString().contains("no poses of both belong together"), err.toString());
  }

  @Test
  void compares_numbers_and_writes_the_differences() throws Exception {
    Path csv = folder.resolve("speed.csv");
    assertEquals(0, compare("--topic", "odom,base linear.x", "--by", "start", "--csv", csv.toString(), "--json"),
        err::toString);
    assertEquals(0.1, figure("difference", "mean"), 1e-9);
    assertEquals(Math.sqrt(0.01 + 0.0004), figure("difference", "rmse"), 1e-9);
    assertEquals(0.12, figure("absolute difference", "max"), 1e-9);
    List<String> lines = Files.readAllLines(csv);
    assertEquals("time [s],difference,absolute difference", lines.getFirst());
    assertEquals(101, lines.size());
    assertTrue(lines.get(1).matches("1700000000\\.000000000,0\\.1199999.*,0\\.11999.*|1700000000\\.000000000,0\\.12.*"),
        lines.get(1));
    assertEquals(2, compare("--topic", "odom,base linear.x", "--by", "start", "--csv", csv.toString()));
    assertTrue(err.toString().contains("is there already"), err.toString());
  }

  @Test
  void pairs_by_an_event_and_by_the_way() {
    assertEquals(0, compare("--topic", "odom,base", "--event", "abs(odom linear.x) > 0 or base linear.x > 0",
        "--align", "yaw", "--json"), err::toString);
    assertEquals(0.02, figure("APE position", "rmse"), 1e-4);
    out.reset();
    assertEquals(0, compare("--topic", "odom,base", "--by", "way", "--align", "se3", "--json"), err::toString);
    assertTrue(figure("APE position", "rmse") < 0.3, out.toString());
    out.reset();
    assertEquals(0, compare("--topic", "odom,base linear.x", "--way", "odom,base", "--json"), err::toString);
    assertEquals(0.1, figure("difference", "mean"), 0.01);
  }

  @Test
  void prints_a_table() {
    assertEquals(0, compare("--topic", "odom,base", "--by", "start", "--align", "se3", "--rpe", "1m"), err::toString);
    List<String> lines = out.toString().lines().toList();
    assertEquals("odom,base: 100 pairs of 100 and 100 values, -100.000 s added to times of the second", lines.get(0));
    assertTrue(lines.get(1).strip().startsWith("count"), lines.get(1));
    assertTrue(lines.get(2).startsWith("APE position [m]                100     0.01999")
        || lines.get(2).startsWith("APE position [m]                100     0.02000"), lines.get(2));
    assertTrue(lines.get(4).startsWith("RPE position per 1 m [m]"), lines.get(4));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {"--align se3|needs --topic", "--topic odom|has no topic 'odom'; it has base",
      "--topic odom,base --align best|--align takes none, origin, yaw, se3", "--topic odom,base --by luck|--by takes",
      "--topic odom,base --rpe half|neither a number of poses", "--topic odom,base --rpe 0|relative errors are taken",
      "--topic a,b,c|neither a topic such as odom", "--topic odom,base --by event|--by event needs --event",
      "--topic odom,base --max-diff -1|--max-diff takes a number", "--topic odom,base --speed 2|has no option --speed",
      "--topic odom,base --event scan|", "--topic odom,base --event scan_stale --by way|"})
  void names_what_is_wrong(String words, String expected) {
    assertEquals(2, compare(words.split(" ")), out::toString);
    assertTrue(expected == null || err.toString().contains(expected), err.toString());
    assertTrue(err.toString().startsWith("robotui: "), err.toString());
  }

  private int compare(String... options) {
    List<String> words = new ArrayList<>(List.of("compare", first.toString(), second.toString()));
    words.addAll(List.of(options));
    return new LogTool(new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8)).run(words);
  }

  private double figure(String name, String figure) {
    Matcher found = Pattern.compile("\"name\":\"" + Pattern.quote(name) + "\"[^}]*\"" + figure + "\":([-0-9.E]+)")
        .matcher(out.toString());
    assertTrue(found.find(), out.toString());
    return Double.parseDouble(found.group(1));
  }
}
