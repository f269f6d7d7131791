package org.robotui.rfic.recording.internal.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.WriterOptions;
import org.robotui.rfic.recording.internal.file.ChannelFormats;
import org.robotui.rfic.recording.internal.file.RecordingFiles;

class TopicExportTest {
  private static final long START = 1_500_000_000_000_000_001L;

  @TempDir
  private Path folder;
  private int files;

  private Path recording(String topic, String... messages) throws IOException {
    Path file = folder.resolve("run" + files++ + ".mcap");
    try (RecordingWriter writer = RecordingWriter.create(file, WriterOptions.defaults())) {
      RecordedChannel channel = writer.channel(topic, "json", RecordedSchema.NONE, Map.of());
      writer.channel("/silent", "json", RecordedSchema.NONE, Map.of());
      for (int i = 0; i < messages.length; i++) {
        writer.write(channel, START + i * 500_000_000L, START, i,
            ByteBuffer.wrap(messages[i].getBytes(StandardCharsets.UTF_8)));
      }
    }
    return file;
  }

  private List<ExportedFile> export(Path file, ExportFormat format) throws IOException {
    return export(file, format, RecordingPart.ALL);
  }

  private List<ExportedFile> export(Path file, ExportFormat format, RecordingPart part) throws IOException {
    try (RecordingReader reader = RecordingFiles.open(file, List.of(), ScanProgress.NONE)) {
      return new TopicExport(reader, part, folder.resolve("out"), format)
          .run(new ChannelFormats(new PayloadFormats(new RosDefinitions(Map.of()))));
    }
  }

  private List<String> lines(String name) throws IOException {
    return Files.readAllLines(folder.resolve("out").resolve(name));
  }

  @Test
  void columnsAreThoseThatAnyMessageHas() throws IOException {
    List<ExportedFile> files = export(recording("/arm/state", "{\"a\": 1, \"list\": [1.5]}",
        "{\"list\": [2, 3], \"in\": {\"text\": \"say \\\"no\\\", twice\"}}", "{\"a\": true, \"list\": []}"),
        ExportFormat.CSV);
    assertEquals(List.of("time [s],elapsed [s],a,list[0],list[1],in.text",
        "1500000000.000000001,0.000000000,1,1.5,,",
        "1500000000.500000001,0.500000000,,2,3,\"say \"\"no\"\", twice\"",
        "1500000001.000000001,1.000000000,true,,,"), lines("arm_state.csv"));
    assertEquals(1, files.size(), "what has no message has no file");
    assertTrue(files.getFirst().isWhole());
    assertEquals("/arm/state " + folder.resolve("out/arm_state.csv") + ": 3 messages", files.getFirst().toString());
  }

  @Test
  void longArraysAreCutAndSaySo() throws IOException {
    String many = IntStream.range(0, 600).mapToObj(String::valueOf).collect(Collectors.joining(",", "[", "]"));
    List<ExportedFile> files = export(recording("many", "{\"v\": " + many + "}", "{\"v\": [7]}"), ExportFormat.CSV);
    List<String> lines = lines("many.csv");
    assertTrue(lines.getFirst().startsWith("time [s],elapsed [s],v.length,v[0],v[1],"));
    assertTrue(lines.getFirst().endsWith(",v[511]"));
    assertTrue(lines.get(1).contains(",600,0,1,2,") && lines.get(1).endsWith(",511"));
    assertTrue(lines.get(2).contains(",1,7,,,"));
    assertTrue(files.getFirst().note().contains("first 512 elements"));
    Path other = recording("many", "{\"v\": " + many + "}");
    export(other, ExportFormat.JSONL);
    String line = lines("many.jsonl").getFirst();
    assertTrue(line.startsWith("{\"time\":1500000000000000001,\"elapsed\":0.0,\"message\":{\"v\":["), line);
    assertEquals(600, line.substring(line.indexOf('[')).split(",").length, "all elements are there");
  }

  @Test
  void aPartKeepsTheTimesOfTheWhole() throws IOException {
    Path file = recording("a", "{\"a\":1}", "{\"a\":2}", "{\"a\":3}");
    RecordingPart part = new RecordingPart(RecordingInterval.from(START + 1), channel -> true);
    export(file, ExportFormat.JSONL, part);
    assertEquals(2, lines("a.jsonl").size());
    assertTrue(lines("a.jsonl").getFirst().contains("\"elapsed\":0.5"), lines("a.jsonl").getFirst());
  }

  @Test
  void whatCannotBeReadIsCountedAndNothingIsOverwritten() throws IOException {
    Path file = recording("../x y", "{\"a\":1}", "no json", "{\"a\":3}");
    ExportedFile outcome = export(file, ExportFormat.CSV).getFirst();
    assertEquals("2 1 false", outcome.lines() + " " + outcome.unreadable() + " " + outcome.isWhole());
    assertEquals(3, lines("topic.._x_y.csv").size(), "the name of a topic leads to no other folder");
    assertTrue(assertThrows(IOException.class, () -> export(file, ExportFormat.CSV)).getMessage()
        .contains("is there already"));
  }
}
