package org.robotui.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.xbot.Timing;

class LayoutTest {
  private final Layout layout = Layout.shipped();

  @Test
  void theBundlesCopyIsThatOfTheNativeSide() throws IOException {
    try (var stream = Layout.class.getResourceAsStream("layout.txt")) {
      assertEquals(Files.readString(NativeFiles.of("link/layout.txt")),
          new String(stream.readAllBytes(), StandardCharsets.UTF_8));
    }
  }

  @Test
  void aPathLeadsThroughStructs() {
    assertEquals(layout.offset("StateSegment", "loop") + layout.offset("LoopStatistics", "busy")
        + layout.offset("Histogram", "buckets"), layout.offset("StateSegment", "loop.busy.buckets"));
  }

  @Test
  void whatIsNotThereIsNamed() {
    assertEquals("no field elbow in JointState",
        assertThrows(IllegalArgumentException.class, () -> layout.offset("JointState", "elbow")).getMessage());
  }

  /** Every value that the native side wrote is found where this side looks for it. */
  @ParameterizedTest
  @ValueSource(strings = {"state-frame", "host", "board"})
  void bothSidesSeeTheSameBytes(String vector) throws IOException {
    List<String> lines = Files.readAllLines(NativeFiles.of("tests/vectors/" + vector + ".txt"));
    Plain plain = new Plain(layout, lines.getFirst().split(" ")[1]);
    ByteBuffer bytes = NativeFiles.vector(vector).copy(0, plain.size());
    for (String line : lines.subList(1, lines.size())) {
      int space = line.indexOf(' ');
      String path = line.substring(0, space);
      assertEquals(line.substring(space + 1), plain.text(bytes, path, line.substring(space + 1)), path);
    }
  }

  @Test
  void bucketsBeginWhereTheNativeSideSays() {
    assertEquals(64, Timing.Buckets.lower(0));
    assertEquals(80, Timing.Buckets.lower(1));
    assertEquals(4096, Timing.Buckets.lower(24));
  }
}
