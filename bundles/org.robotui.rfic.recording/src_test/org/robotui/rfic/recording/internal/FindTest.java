package org.robotui.rfic.recording.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.rfic.recording.internal.SmallRecording.time;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.replay.FoundEvent;
import org.robotui.api.replay.SearchReport;
import org.robotui.api.replay.SearchTaker;
import org.robotui.recording.RecordingException;
import org.robotui.rfic.recording.internal.find.OpenRecordingSearch;

class FindTest {
  private static final Map<String, Object> STANDING = Map.of("play", false);
  private static final int LENGTH = 60;
  /** The charge by second: it is low twice, the second time until the end, and for a moment before. */
  private static final List<double[]> LOW = List.of(new double[]{10, 12}, new double[]{20, 30}, new double[]{50, 61});

  @TempDir
  private Path folder;
  private final PlayBench bench = new PlayBench();
  private OpenRecordingSearch search;

  private static final class Taken implements SearchTaker {
    private final List<FoundEvent> events = new ArrayList<>();
    private final List<Double> shares = new ArrayList<>();
    private int most = Integer.MAX_VALUE;

    @Override
    public void found(FoundEvent event) {
      events.add(event);
    }

    @Override
    public boolean reached(double share) {
      shares.add(share);
      return shares.size() < most;
    }

    private String text() {
      StringBuilder text = new StringBuilder();
      for (FoundEvent each : events) {
        text.append(String.format("%.3f..%.3f%s %s%n", seconds(each.range().start()), seconds(each.range().end()),
            each.over() ? "" : "+", each.words()));
      }
      return text.toString().strip();
    }

    private static double seconds(long time) {
      return (time - SmallRecording.BEGIN) / 1e9;
    }
  }

  @BeforeEach
  void record() throws RecordingException {
    Path file = folder.resolve("run.mcap");
    try (SmallRecording recording = new SmallRecording(file)) {
      for (int i = 0; i <= LENGTH; i++) {
        double second = i;
        boolean low = LOW.stream().anyMatch(each -> second >= each[0] && second < each[1]);
        recording.say("/battery", "sensor_msgs/msg/BatteryState", Map.of(), i, Map.of("header",
            SmallRecording.header(i - (i == 40 ? 0.5 : 0.01), ""), "voltage", 12.0, "percentage", low ? 0.125 : 0.9));
        recording.say("/mode", "std_msgs/msg/String", Map.of(), i + 0.5, Map.of("data", i < 7 ? "manual" : "auto"));
        if (i < 33 || i > 36) {
          recording.odometry("/odom", i + 0.25, i);
        }
      }
    }
    bench.open(file, STANDING);
    search = new OpenRecordingSearch(bench.timeline);
  }

  @AfterEach
  void close() {
    bench.close();
  }

  private String find(String condition) throws Exception {
    Taken taken = new Taken();
    SearchReport report = search.search(condition, taken);
    assertEquals(List.of(), report.problems());
    assertTrue(report.values() > 0);
    assertEquals(1, taken.shares.getLast(), 1e-9);
    return taken.text();
  }

  @Test
  void whatLastsIsFoundFromItsBeginToItsEnd() throws Exception {
    assertEquals("""
        10.000..12.000 battery.charge is 0.125
        20.000..30.000 battery.charge is 0.125
        50.000..60.500+ battery.charge is 0.125""", find("battery charge < 0.2"));
  }

  @Test
  void whatDoesNotLastLongEnoughIsLeftOut() throws Exception {
    assertEquals("""
        20.000..30.000 battery.charge is 0.125
        50.000..60.500+ battery.charge is 0.125""", find("battery charge < 0.2 for 5 s"));
    assertEquals("", find("battery charge < 0.2 for 20 s"));
  }

  /** Nothing is said while it begins: when, is told by time alone. */
  @Test
  void aGapBeginsWhereTheLastMessageIsTooOld() throws Exception {
    assertEquals("33.750..37.250 the age of odom is 1.5 s", find("age(odom) > 1.5").replace("33.751", "33.750"));
    assertEquals("35.250..37.250 odom sent nothing for 3.0 s", find("odom stale").replace("35.251", "35.250"));
  }

  @Test
  void aChangeIsAMoment() throws Exception {
    assertEquals("7.500..7.500 mode.data is auto, was manual", find("mode data changes"));
  }

  @Test
  void aLateStampIsFound() throws Exception {
    assertEquals("40.000..41.000 the delay of battery is 0.500 s", find("delay(battery) > 0.1"));
  }

  @Test
  void conditionsAreCombined() throws Exception {
    assertEquals("20.000..30.000 odom.pose.translation.x, battery.charge are 19.0, 0.125",
        find("odom pose.translation.x > 15 and battery charge < 0.2 and odom pose.translation.x < 40"));
  }

  @Test
  void eachRecordingIsSearchedByItselfInItsOwnTime() throws Exception {
    Path other = folder.resolve("other.mcap");
    try (SmallRecording recording = new SmallRecording(other)) {
      recording.odometry("/odom", 0, 1).odometry("/odom", 1, 5).odometry("/odom", 2, 1);
    }
    bench.open(other, Map.of("play", false, "offset", 1000.0));
    Taken taken = new Taken();
    search.search("odom pose.translation.x == 5", taken);
    assertEquals("""
        5.250..6.250 odom.pose.translation.x is 5.0
        1.000..2.000 odom.pose.translation.x is 5.0""", taken.text());
    assertEquals(time(1), taken.events.getLast().range().start());
    assertEquals(taken.shares.stream().sorted().toList(), taken.shares);
  }

  @Test
  void mistakesSayWhatCouldBeWritten() {
    assertTrue(search.fault("battery charge <").orElseThrow().contains("battery charge < 0.2"));
    assertTrue(search.fault("battery charge < 0.2 for 3 s").isEmpty());
    String nothing = assertThrows(IllegalArgumentException.class, () -> search.search("sonar range < 1", new Taken()))
        .getMessage();
    assertEquals("nothing of what the condition names was recorded; there is battery, mode, odom", nothing);
    String field = assertThrows(IllegalArgumentException.class, () -> search.search("battery amps < 1", new Taken()))
        .getMessage();
    assertTrue(field.startsWith("battery (sensor_msgs/BatteryState) has no field 'amps'; it has header"), field);
  }

  @Test
  void aSearchEndsWhereNoMoreIsWanted() throws Exception {
    Taken taken = new Taken();
    taken.most = 1;
    search.search("battery charge < 0.2", taken);
    assertEquals(List.of(), taken.events);
  }
}
