package org.robotui.rfic.recording.internal.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.WriterOptions;

class LogToolTest {

  @TempDir
  private Path folder;
  private Path file;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @BeforeEach
  void record() throws Exception {
    file = folder.resolve("recording.mcap");
    try (RecordingWriter writer = RecordingWriter.create(file, WriterOptions.defaults())) {
      RecordedChannel channel =
          writer.channel("/a", "cdr", new RecordedSchema("pkg/msg/A", "ros2msg", new byte[3]), Map.of("k", "\"v\"\n"));
      writer.note(new RecordedMetadata("place", Map.of()));
      writer.write(channel, 1_500_000_000L, 0, 0, ByteBuffer.allocate(10));
      writer.write(channel, 2_750_000_000L, 0, 0, ByteBuffer.allocate(10));
    }
  }

  @Test
  void tells_what_is_in_a_recording() {
    assertEquals(0, run("info", file.toString()));
    assertEquals(file + ": mcap\n1970-01-01T00:00:01.500Z to 1970-01-01T00:00:02.750Z, 1.250 s\n2 messages\n"
        + "           2  /a  pkg/msg/A  cdr\nnote place {}\n", out.toString());
  }

  @Test
  void tells_it_to_programs() {
    assertEquals(0, run("check", "--json", file.toString()));
    assertEquals("{\"file\":\"" + file + "\",\"format\":\"mcap\",\"indexed\":true,\"start\":\"1500000000\","
        + "\"end\":\"2750000000\",\"messages\":2,\"read\":2,\"channels\":[{\"topic\":\"/a\",\"type\":\"pkg/msg/A\","
        + "\"encoding\":\"cdr\",\"schemaEncoding\":\"ros2msg\",\"messages\":2,\"metadata\":{\"k\":\"\\\"v\\\"\\u000a\"}}],"
        + "\"attachments\":[],\"metadata\":[{\"name\":\"place\",\"values\":{}}],\"damages\":[]}\n", out.toString());
  }

  @Test
  void finds_damages_and_repairs_them() throws Exception {
    byte[] whole = Files.readAllBytes(file);
    Files.write(file, Arrays.copyOf(whole, whole.length - 20));
    assertEquals(1, run("check", file.toString()));
    assertTrue(out.toString().startsWith("2 messages can be read\nbyte "), out.toString());

    String repaired = folder.resolve("repaired.mcap").toString();
    assertEquals(0, run("repair", "--compression", "lz4", file.toString(), repaired));
    assertEquals(0, run("check", repaired));
    assertTrue(out.toString().endsWith("2 messages can be read\n"), out.toString());
    assertEquals(2, run("repair", file.toString(), repaired));
    assertTrue(err.toString().contains(repaired + " is there already"), err.toString());
  }

  @Test
  void cuts_a_part_by_seconds_and_by_times() throws Exception {
    String part = folder.resolve("part.mcap").toString();
    assertEquals(0, run("cut", "--from", "0.5", file.toString(), part));
    assertTrue(out.toString().startsWith("1 messages were written to "), out.toString());
    assertEquals(0, run("cut", "--to", "1970-01-01T00:00:02Z", "--topics", "/b, /*", file.toString(), part + "2"));
    assertEquals(0, run("info", part + "2"));
    assertTrue(out.toString().contains("1970-01-01T00:00:01.500Z to 1970-01-01T00:00:01.500Z"), out.toString());
    assertEquals(2, run("cut", "--topics", "/none*", file.toString(), part + "3"));
    assertTrue(err.toString().contains("no topic fits --topics"), err.toString());
    assertFalse(Files.exists(Path.of(part + "3")));
  }

  @Test
  void takes_along_what_holds_at_the_beginning_of_a_part() throws Exception {
    Path latched = folder.resolve("latched.mcap");
    try (RecordingWriter writer = RecordingWriter.create(latched, WriterOptions.defaults())) {
      RecordedChannel map = writer.channel("/map", "cdr", RecordedSchema.NONE,
          Map.of("offered_qos_profiles", "- durability: transient_local"));
      RecordedChannel scan = writer.channel("/scan", "cdr", RecordedSchema.NONE, Map.of());
      writer.write(map, 1_000_000_000L, 900, 1, ByteBuffer.allocate(1));
      writer.write(map, 2_000_000_000L, 901, 2, ByteBuffer.allocate(2));
      writer.write(scan, 2_100_000_000L, 902, 3, ByteBuffer.allocate(3));
      writer.write(scan, 5_000_000_000L, 903, 4, ByteBuffer.allocate(4));
    }
    Path part = folder.resolve("part.mcap");
    assertEquals(0, run("cut", "--from", "3", latched.toString(), part.toString()));
    assertEquals(List.of("/map 4000000000 901 2", "/scan 5000000000 903 4"), read(part));
  }

  private Path battery(String name, double... charges) throws Exception {
    Path run = folder.resolve(name);
    try (RecordingWriter writer = RecordingWriter.create(run, WriterOptions.defaults())) {
      RecordedChannel battery = writer.channel("/battery", "json", RecordedSchema.NONE, Map.of());
      for (int i = 0; i < charges.length; i++) {
        String message = Double.isNaN(charges[i]) ? "{" : "{\"charge\":" + charges[i] + "}";
        byte[] bytes = message.getBytes(StandardCharsets.UTF_8);
        writer.write(battery, (i + 1) * 1_000_000_000L, 0, i, ByteBuffer.wrap(bytes));
      }
    }
    return run;
  }

  @Test
  void finds_when_something_was_so() throws Exception {
    Path one = battery("one.mcap", 0.9, 0.1, 0.15, 0.9, 0.1, 0.9);
    Path two = battery("two.mcap", 0.9, 0.05);
    assertEquals(0, run("find", one.toString(), two.toString(), "--where", "battery charge < 0.2"));
    assertEquals(one + "  1970-01-01T00:00:02Z  1.000 s, for 2.000 s: battery.charge is 0.1\n"
        + one + "  1970-01-01T00:00:05Z  4.000 s, for 1.000 s: battery.charge is 0.1\n"
        + two + "  1970-01-01T00:00:02Z  1.000 s, for 0.000 s until the end: battery.charge is 0.05\n"
        + "3 events were found\n", out.toString());
  }

  @Test
  void tells_programs_what_it_found() throws Exception {
    Path run = battery("one.mcap", 0.9, 0.1, 0.15, 0.9, 0.1, 0.9);
    assertEquals(0, run("find", "--json", "--where", "battery charge < 0.2 for 1.5 s", run.toString()));
    assertEquals("{\"file\":\"" + run + "\",\"start\":\"2000000000\",\"end\":\"4000000000\",\"over\":true,"
        + "\"what\":\"battery.charge is 0.1\"}\n", out.toString());
  }

  @Test
  void finds_in_a_part_only() throws Exception {
    Path run = battery("one.mcap", 0.9, 0.1, 0.15, 0.9, 0.1, 0.9);
    assertEquals(0, run("find", "--from", "3.5", "--where", "battery charge < 0.2", run.toString()));
    assertTrue(out.toString().endsWith("1 event was found\n"), out.toString());
  }

  @ParameterizedTest
  @CsvSource({"battery charge <, such as|write", "sonar range < 1, 'there is battery'",
      "battery amps < 1, has no field 'amps'", "link lost, nothing of what the condition names was recorded"})
  void a_search_for_nothing_is_refused(String where, String why) throws Exception {
    Path run = battery("one.mcap", 0.9, 0.1);
    assertEquals(2, run("find", "--where", where, run.toString()), out.toString());
    assertTrue(Arrays.stream(why.split("\\|")).anyMatch(err.toString()::contains), err.toString());
  }

  @Test
  void what_could_not_be_looked_at_is_told() throws Exception {
    Path run = battery("one.mcap", 0.9, 0.1, Double.NaN, 0.9);
    assertEquals(1, run("find", "--where", "battery charge < 0.2", run.toString()));
    assertTrue(err.toString().contains("a message could not be read, the first: battery: "), err.toString());
    assertTrue(out.toString().contains("1 event was found"), out.toString());
  }

  @Test
  void writes_a_report_to_a_new_file_only() throws Exception {
    Path run = battery("run.mcap", 0.9, 0.5, Double.NaN, 0.1);
    Path page = folder.resolve("run.html");
    assertEquals(0, run("report", run.toString(), "--out", page.toString()), err.toString());
    String text = Files.readString(page);
    assertTrue(text.contains("<h1>run.mcap</h1>") && text.contains("messages of battery could not be read: "), text);
    assertEquals(2, run("report", run.toString(), "--out", page.toString()));
    assertEquals("robotui: " + page + " is there already: name a file that is new\n", err.toString());
    assertEquals(2, run("report", "--from", "60", run.toString(), "--out", folder.resolve("new").toString()));
    assertEquals("robotui: " + run + " has no message in that time\n", err.toString());
    assertEquals(2, run("report", run.toString(), "--out", folder.resolve("none/new.html").toString()));
    assertTrue(err.toString().contains("could not be written"), err.toString());
  }

  private Path named(String name, long later) throws Exception {
    Path run = folder.resolve(name);
    try (RecordingWriter writer = RecordingWriter.create(run, WriterOptions.defaults())) {
      RecordedChannel channel = writer.channel("/state", "json", RecordedSchema.NONE, Map.of());
      for (int i = 0; i < 10; i++) {
        byte[] bytes = ("{\"number\":" + i + ",\"what\":\"step\"}").getBytes(StandardCharsets.UTF_8);
        writer.write(channel, (i + 1) * 1_000_000_000L + later, 0, i, ByteBuffer.wrap(bytes));
      }
    }
    return run;
  }

  @Test
  void tells_how_far_clocks_are_apart() throws Exception {
    String one = named("one.mcap", 0).toString();
    String other = named("other.mcap", 2_500_000_000L).toString();
    assertEquals(0, run("offset", one, other), err.toString());
    assertEquals("add -2.500 s to the times of " + other
        + ", with a deviation of 0.000 s: 10 messages that both have\n", out.toString());
    out.reset();
    assertEquals(0, run("offset", "--json", one, other));
    assertEquals("{\"offset\":\"-2500000000\",\"deviation\":\"0\",\"basis\":\"10 messages that both have\"}\n",
        out.toString());
    out.reset();
    assertEquals(1, run("offset", one, battery("run.mcap", 0.5).toString()));
    assertTrue(out.toString().startsWith("it cannot be told: "), out.toString());
    assertEquals(2, run("offset", one));
    assertTrue(err.toString().startsWith("robotui: log offset takes two files: "), err.toString());
  }

  @Test
  void merges_recordings_by_their_times() throws Exception {
    Path other = folder.resolve("other.mcap");
    try (RecordingWriter writer = RecordingWriter.create(other, WriterOptions.defaults())) {
      RecordedChannel same =
          writer.channel("/a", "cdr", new RecordedSchema("pkg/msg/A", "ros2msg", new byte[3]), Map.of("k", "\"v\"\n"));
      RecordedChannel more = writer.channel("/b", "cdr", RecordedSchema.NONE, Map.of());
      writer.write(same, 1_600_000_000L, 7, 7, ByteBuffer.allocate(1));
      writer.write(more, 1_500_000_000L, 8, 8, ByteBuffer.allocate(1));
    }
    Path all = folder.resolve("all.mcap");
    assertEquals(0, run("merge", file.toString(), other.toString(), all.toString()));
    assertEquals(List.of("/a 1500000000 0 0", "/b 1500000000 8 8", "/a 1600000000 7 7", "/a 2750000000 0 0"),
        read(all));
    try (RecordingReader reader = Recordings.open(all, ScanProgress.NONE)) {
      assertEquals(2, reader.channels().size(), "channels that are alike are one");
    }
  }

  private static List<String> read(Path recording) throws Exception {
    try (RecordingReader reader = Recordings.open(recording, ScanProgress.NONE)) {
      RecordingCursor cursor = reader.cursor(RecordingInterval.ALWAYS, Set.of());
      List<String> all = new ArrayList<>();
      for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
        RecordedMessage m = next.get();
        all.add(m.channel().topic() + " " + m.logTime() + " " + m.publishTime() + " " + m.sequence());
      }
      return all;
    }
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {"log knows info FILE|", "takes one file|info", "log knows info FILE|burn a",
      "log info has no option --all|info --all a", "takes a file and the name of a new one|repair a",
      "log convert has no option --json|convert --json a b",
      "log info has no option --compression|info --compression lz4 a",
      "takes none, lz4 or zstd, not 'rar'|convert --compression rar a b",
      "--compression needs a value|convert a b --compression",
      "takes two files or more|merge a b", "not 'noon'|cut --from noon a b", "not '-1'|cut --to -1 a b",
      "log repair has no option --from|repair --from 1 a b", "log report needs --out and the page|report a",
      "log report has no option --topics|report a --out b --topics c"})
  void says_what_it_does_not_know(String sentence, String words) {
    assertEquals(2, run(words == null ? new String[0] : words.split(" ")));
    assertTrue(err.toString().startsWith("robotui: ") && err.toString().contains(sentence), err.toString());
  }

  @Test
  void says_what_cannot_be() {
    assertEquals(2, run("info", folder.resolve("none").toString()));
    assertEquals(2, run("cut", "--from", "2", "--to", "1", file.toString(), folder.resolve("new").toString()));
    assertEquals("robotui: --to lies before --from\n", err.toString());
  }

  private int run(String... arguments) {
    err.reset();
    return new LogTool(new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8)).run(List.of(arguments));
  }
}
