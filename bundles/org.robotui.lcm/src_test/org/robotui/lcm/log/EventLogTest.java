package org.robotui.lcm.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.lcm.SharedData;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.RecordException;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;

/** Logs: recorded ones, damaged ones, and our own. */
class EventLogTest {

  @TempDir
  private Path folder;

  private static List<LogEvent> all(EventLogReader reader) throws IOException {
    List<LogEvent> events = new ArrayList<>();
    for (Optional<LogEvent> next = reader.next(); next.isPresent(); next = reader.next()) {
      events.add(next.get());
    }
    return events;
  }

  private static List<LogEvent> all(Path path) throws IOException {
    try (EventLogReader reader = EventLogReader.open(path)) {
      return all(reader);
    }
  }

  private Path log(int events) throws IOException {
    Path path = folder.resolve("made.lcmlog");
    try (EventLogWriter writer = EventLogWriter.create(path)) {
      for (int i = 0; i < events; i++) {
        writer.write(1_000_000L * i, i % 2 == 0 ? "EVEN" : "ODD",
            ByteBuffer.wrap(("event " + i).getBytes(StandardCharsets.UTF_8)));
      }
    }
    return path;
  }

  @Test
  void recordedMessagesAreDecodedByTheirTypes() throws IOException, RecordException {
    TypeLibrary types = TypeFolder.read(List.of(SharedData.lcm("types")));
    assertEquals(List.of(), types.problems());
    List<LogEvent> events = all(SharedData.lcm("sena_loop.lcmlog"));
    assertEquals(450, events.size());
    assertEquals(1137834225973760L, events.getFirst().utime());
    assertEquals(1137834284788331L, events.getLast().utime());
    for (LogEvent event : events) {
      LcmRecord record = types.decode(event.data());
      assertEquals(Map
          .of("ODOMETRY", "robotdata.odometry_t", "LASER_FRONT", "robotdata.laser_scan_t", "MAP",
              "robotdata.occupancy_grid_t")
          .get(event.channel()), record.type());
      assertEquals(event.data(), types.type(record.type()).orElseThrow().encode(record), event.channel());
    }
    LcmRecord map =
        types.decode(events.stream().filter(event -> event.channel().equals("MAP")).findFirst().orElseThrow().data());
    assertEquals(352, map.number("robot.column").orElseThrow());
    assertEquals(435, map.number("robot.row").orElseThrow());
    assertEquals(List.of(717, 651), map.numbers("cells").orElseThrow().shape());
  }

  @Test
  void anIndexFindsTimesAndChannels() throws IOException {
    EventLogIndex index = EventLogIndex.of(SharedData.lcm("sena_loop.lcmlog"));
    assertEquals(Map.of("ODOMETRY", 224, "LASER_FRONT", 224, "MAP", 2), index.channels());
    int at = index.at(index.utime(200));
    assertEquals(index.utime(200), index.utime(at));
    assertTrue(at == 0 || index.utime(at - 1) < index.utime(at));
    assertEquals(450, index.at(Long.MAX_VALUE));
    assertEquals(0, index.at(0));
  }

  @Test
  void seekingFindsTheFirstEventFromATimeOn() throws IOException {
    try (EventLogReader reader = EventLogReader.open(log(1000))) {
      for (long utime : new long[]{0, 1, 499_999_999, 500_000_000, 999_000_000}) {
        reader.seekToTime(utime);
        assertEquals((utime + 999_999) / 1_000_000, reader.next().orElseThrow().number(), "from " + utime);
      }
      reader.seekToTime(999_000_001);
      assertEquals(Optional.empty(), reader.next());
      reader.seek(0);
      assertEquals(1000, all(reader).size());
      assertEquals(0, reader.damagedBytes());
    }
  }

  @Test
  void anotherWriterGoesOnWhereTheFirstEnded() throws IOException {
    Path path = log(3);
    try (EventLogWriter writer = EventLogWriter.append(path)) {
      writer.write(9_000_000, "LAST", ByteBuffer.allocate(0));
    }
    LogEvent last = all(path).getLast();
    assertEquals(3, last.number());
    assertEquals("LAST", last.channel());
    assertEquals(0, last.data().remaining());
  }

  /** Whatever byte is changed, all events but the changed one, or one more, are read. */
  @Test
  void aChangedByteCostsOneEvent() throws IOException {
    byte[] whole = Files.readAllBytes(log(20));
    Path damaged = folder.resolve("damaged.lcmlog");
    for (int at = 0; at < whole.length; at++) {
      byte[] bytes = whole.clone();
      bytes[at] ^= (byte) 0x95;
      Files.write(damaged, bytes);
      List<LogEvent> read = all(damaged);
      assertTrue(read.size() >= 19 && read.size() <= 20, "byte " + at + ": " + read.size() + " events");
    }
  }

  @Test
  void afterACutAndWhatWasAppendedAllWholeEventsAreRead() throws IOException {
    byte[] whole = Files.readAllBytes(log(20));
    Path path = folder.resolve("cut.lcmlog");
    for (int cut = 1; cut < 80; cut++) {
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      out.write(whole, 0, whole.length - cut);
      Files.write(path, out.toByteArray());
      int before = all(path).size();
      out.write(whole);
      Files.write(path, out.toByteArray());
      assertEquals(before + 20, all(path).size(), "cut by " + cut);
    }
  }

  @Test
  void whatIsBetweenEventsIsCounted() throws IOException {
    byte[] whole = Files.readAllBytes(log(2));
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(whole);
    out.write(new byte[100_000]);
    out.write(whole);
    Path path = Files.write(folder.resolve("gap.lcmlog"), out.toByteArray());
    try (EventLogReader reader = EventLogReader.open(path)) {
      assertEquals(4, all(reader).size());
      assertEquals(100_000, reader.damagedBytes());
    }
  }

  @Test
  void aLogThatIsStillWrittenIsReadOnceAnEventIsWhole() throws IOException {
    byte[] whole = Files.readAllBytes(log(2));
    Path path = Files.write(folder.resolve("growing.lcmlog"), Arrays.copyOf(whole, whole.length - 3));
    try (EventLogReader reader = EventLogReader.open(path)) {
      assertEquals(1, all(reader).size());
      Files.write(path, whole);
      assertEquals(1, all(reader).size());
      assertEquals(0, reader.damagedBytes());
    }
  }

  @Test
  void filesThatCannotBeOpenedAreNamed() {
    IOException missing = assertThrows(IOException.class, () -> EventLogReader.open(folder.resolve("none.lcmlog")));
    assertTrue(missing.getMessage().contains("none.lcmlog cannot be opened"), missing.getMessage());
    IOException unwritable =
        assertThrows(IOException.class, () -> EventLogWriter.create(folder.resolve("none/x.lcmlog")));
    assertTrue(unwritable.getMessage().contains("x.lcmlog cannot be written"), unwritable.getMessage());
  }
}
