package org.robotui.lcm;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.lcm.log.EventLogReader;
import org.robotui.lcm.log.EventLogWriter;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.RecordException;
import org.robotui.lcm.type.TypeException;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.lcm.type.TypeParser;

/** Logs, type files and messages that are damaged or meant to harm. */
class HostileFilesTest {

  private static final String TYPES = """
      package robot; // comment
      struct point_t { double x, y, z; }
      struct scan_t { const int32_t MAX = 0x10, MIN = -1; int64_t utime; int16_t n; float ranges[n]; string names[n][2]; point_t at; point_t path[n];
        byte raw[3]; boolean ok; scan_t children[n]; }
      enum mode_t { IDLE, RUN = 4 }
      """;

  @TempDir
  private Path folder;

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void damagedLogsAreReadToTheirEnd(long seed) throws IOException {
    Path good = folder.resolve("good.lcmlog");
    try (EventLogWriter writer = EventLogWriter.create(good)) {
      for (int i = 0; i < 40; i++) {
        writer.write(1_000_000L + i, "CHANNEL_" + i % 3, ByteBuffer.allocate(i * 7));
      }
    }
    byte[] bytes = Files.readAllBytes(good);
    Mutator mutator = new Mutator(seed);
    Path damaged = folder.resolve("damaged.lcmlog");
    long events = 0;
    long lost = 0;
    for (int i = 0; i < 300; i++) {
      Files.write(damaged, mutator.mutate(bytes));
      try (EventLogReader reader = EventLogReader.open(damaged)) {
        while (reader.next().isPresent()) {
          events++;
        }
        lost += reader.damagedBytes();
      }
    }
    assertTrue(events > 300 * 20 && lost > 0, events + " events, " + lost + " bytes lost");
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void damagedTypeFilesAreReadOrRefusedWithTheirPlace(long seed) {
    Mutator mutator = new Mutator(seed);
    int read = 0;
    int refused = 0;
    for (int i = 0; i < 5000; i++) {
      String text = new String(mutator.mutate(TYPES.getBytes(StandardCharsets.UTF_8)), StandardCharsets.UTF_8);
      try {
        read += TypeLibrary.of(TypeParser.parse("types.lcm", text), List.of()).types().size();
      } catch (TypeException e) {
        assertTrue(e.getMessage().matches("(?s)types.lcm:\\d+:\\d+: .+; .+"), e.getMessage());
        refused++;
      }
    }
    assertTrue(read > 100 && refused > 500, read + " read, " + refused + " refused");
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void damagedMessagesAreDecodedOrRefusedWithTheirPlace(long seed) throws TypeException {
    TypeLibrary types = TypeLibrary.of(TypeParser.parse("types.lcm", TYPES), List.of());
    LcmType scan = types.type("robot.scan_t").orElseThrow();
    ByteBuffer whole = scan.encode(scan.builder().numbers("ranges", 1, 2, 3).build());
    byte[] bytes = new byte[whole.remaining()];
    whole.get(bytes);
    Mutator mutator = new Mutator(seed);
    int decoded = 0;
    int refused = 0;
    for (int i = 0; i < 20_000; i++) {
      try {
        decoded += types.decode(ByteBuffer.wrap(mutator.mutate(bytes))).members().size();
      } catch (RecordException e) {
        assertTrue(e.offset() >= 0 && !e.problem().isBlank(), e.getMessage());
        refused++;
      }
    }
    assertTrue(decoded > 2000 && refused > 2000, decoded + " decoded, " + refused + " refused");
  }
}
