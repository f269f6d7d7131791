package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.invoke.MethodHandles;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;

import org.junit.jupiter.api.Test;

/** Records that users write are compared with the definition when they are bound. */
class RecordBindingTest {

  private static final String TRACK = """
      string name
      time begin
      duration[2] waits
      uint32 count
      Spot[] spots
      Label[] labels
      int16[] codes
      uint64 big
      ================================================================================
      MSG: lab_msgs/Spot
      float64 x
      float64 y
      ================================================================================
      MSG: lab_msgs/Label
      string text
      Spot spot
      """;

  private record Spot(double x, double y) {}

  private record Label(Spot spot, String text) {}

  private record Track(
      List<Label> labels, String name, long begin, long count, double[] spots, short[] codes, long big) {}

  private record Short(String name) {}

  private record Typo(String nam) {}

  private record Narrow(int count) {}

  private record Times(long[] waits) {}

  private record Numbers(List<Integer> codes) {}

  record Picky(String name) {
    Picky {
      throw new IllegalArgumentException("never good: " + name);
    }
  }

  private static MessageSchema schema() throws DefinitionException {
    return MessageSchema.parse("lab_msgs/Track", TRACK);
  }

  private static <T extends Record> RecordCodec<T> codec(Class<T> type) throws DefinitionException {
    return RecordCodec.of(type, schema(), MethodHandles.lookup());
  }

  private static ByteBuffer sample() throws Exception {
    Map<String, Object> spot = Map.of("x", 1, "y", 2);
    return new DynamicCodec(schema()).build(Map.of("name", "loop", "begin", 5_000_000_007L, "count", 4_000_000_000L,
        "waits", List.of(1_000, 2_000), "spots", List.of(spot, spot), "codes", List.of(-1, 2),
        "labels", List.of(Map.of("text", "start", "spot", spot)), "big", "18446744073709551615")).bytes();
  }

  @Test
  void componentsAreFoundByNameInAnyOrder() throws Exception {
    Track track = codec(Track.class).decode(sample());
    assertEquals("loop", track.name());
    assertEquals(5_000_000_007L, track.begin());
    assertEquals(4_000_000_000L, track.count());
    assertArrayEquals(new double[]{1, 2, 1, 2}, track.spots());
    assertArrayEquals(new short[]{-1, 2}, track.codes());
    assertEquals(List.of(new Label(new Spot(1, 2), "start")), track.labels());
    assertEquals(-1, track.big());
  }

  @Test
  void fieldsThatAreLeftOutAreWrittenAsNothing() throws Exception {
    Short read = codec(Short.class).decode(sample());
    assertEquals("loop", read.name());
    MessageWriter out = new MessageWriter();
    codec(Short.class).encode(read, out);
    assertEquals(new DynamicCodec(schema()).build(Map.of("name", "loop")),
        new DynamicCodec(schema()).decode(ByteBuffer.wrap(out.toByteArray())));
  }

  @Test
  void whatDoesNotFitIsNamedWhenItIsBound() {
    assertRefused(Typo.class, "component nam is no field; there are [name, begin");
    assertRefused(Narrow.class, "component count is int, but field count is uint32 and needs long");
    assertRefused(Times.class, "field waits is duration[2] and needs to be left out");
    assertRefused(Numbers.class, "but field codes is int16[] and needs short[]");
  }

  private static <T extends Record> void assertRefused(Class<T> type, String reason) {
    IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> codec(type));
    assertTrue(e.getMessage().contains(reason), e.getMessage());
  }

  @Test
  void aRecordMayRefuseWhatItIsSent() throws Exception {
    RecordCodec<Picky> codec = codec(Picky.class);
    MessageException e = assertThrows(MessageException.class, () -> codec.decode(sample()));
    assertTrue(e.getMessage().contains("never good: loop"), e.getMessage());
  }

  @Test
  void errorsNameThePathAndLengthsAreBoundedBeforeMemoryIsTaken() throws Exception {
    BlockWriter cut = new MessageWriter().string("loop").i64(0).i64(0).i64(0).i32(0).i32(0);
    cut.array(1).string("too long").f64(1).i32(0);
    MessageException e =
        assertThrows(MessageException.class, () -> codec(Track.class).decode(ByteBuffer.wrap(cut.toByteArray())));
    assertEquals("labels[0].spot.y", e.path());
    BlockWriter lie = new MessageWriter().string("loop").i64(0).i64(0).i64(0).i32(0).i32(Integer.MAX_VALUE);
    MessageException lied =
        assertThrows(MessageException.class, () -> codec(Track.class).decode(ByteBuffer.wrap(lie.toByteArray())));
    assertEquals("spots", lied.path());
  }

  @Test
  void numbersThatMakeNoWholeElementsAreNotWritten() throws Exception {
    Track odd = new Track(List.of(), "", 0, 0, new double[3], new short[0], 0);
    assertThrows(IllegalArgumentException.class, () -> codec(Track.class).encode(odd, new MessageWriter()));
  }
}
