package org.robotui.recording.internal.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingWriter;
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
  void says_what_it_does_not_know() {
    for (List<String> wrong : List.of(List.<String>of(), List.of("info"), List.of("burn", "a"),
        List.of("info", "--all", "a"),
        List.of("repair", "a"), List.of("convert", "--json", "a", "b"), List.of("info", "--compression", "lz4", "a"),
        List.of("convert", "--compression", "rar", "a", "b"), List.of("convert", "a", "b", "--compression"))) {
      assertEquals(2, run(wrong.toArray(String[]::new)), wrong.toString());
      assertTrue(err.toString().startsWith("robotui: log knows"), err.toString());
    }
    assertEquals(2, run("info", folder.resolve("none").toString()));
  }

  private int run(String... arguments) {
    err.reset();
    return new LogTool(new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8)).run(List.of(arguments));
  }
}
