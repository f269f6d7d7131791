package org.robotui.lcm.type;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Records of any type: made, encoded, decoded, read. */
class RecordTest {

  private final TypeLibrary zoo = FingerprintsTest.zoo();
  private final LcmType arrays = zoo.type("zoo.arrays_t").orElseThrow();
  private final LcmType scalars = zoo.type("zoo.scalars_t").orElseThrow();
  private final LcmType node = zoo.type("zoo.node_t").orElseThrow();

  private LcmRecord scalars() {
    return scalars.builder().whole("a", -1).whole("b", -300).whole("c", 1 << 30).whole("d", Long.MIN_VALUE)
        .whole("e", 255)
        .real("f", 0.5).whole("g", 3).flag("h", true).text("i", "Grüße").build();
  }

  @Test
  void everyKindOfMemberReturnsFromItsBytes() throws RecordException {
    LcmRecord thing = zoo.type("other.thing_t").orElseThrow().builder().real("weight", 2.5).build();
    LcmRecord record =
        arrays.builder().numbers("fixed", 1, 2, 3, 4).whole("n", 3).whole("m", 1).numbers("cube", 1, 2, 3, 4, 5, 6)
            .bytes("data", ByteBuffer.wrap(new byte[]{1, -1, 7})).texts("names", List.of("one"))
            .numbers("flags", 0, 1, 0, 1, 0, 1)
            .records("parts", List.of(scalars(), scalars(), scalars())).record("one", scalars())
            .records("things", List.of(thing, thing)).build();
    LcmRecord decoded = zoo.decode(arrays.encode(record));
    assertEquals(record, decoded);
    assertEquals(OptionalDouble.of(5), decoded.number("cube[2][0][0]"));
    assertEquals(OptionalDouble.of(255), decoded.number("data[1]"));
    assertEquals(OptionalDouble.of(1), decoded.number("flags[1][0]"));
    assertEquals(OptionalDouble.of(2.5), decoded.number("things[0][1].weight"));
    assertEquals(Optional.of("Grüße"), decoded.text("parts[2].i"));
    assertEquals(OptionalDouble.of(Long.MIN_VALUE), decoded.number("one.d"));
    assertArrayEquals(new double[]{1, 2, 3, 4}, decoded.numbers("fixed").orElseThrow().toDoubles());
    assertArrayEquals(new float[48], decoded.numbers("table").orElseThrow().toFloats());
    assertEquals(List.of(16, 3), decoded.numbers("table").orElseThrow().shape());
  }

  @Test
  void whatIsNotThereIsEmpty() throws RecordException {
    LcmRecord decoded = zoo.decode(arrays.encode(arrays.builder().build()));
    for (String path : List.of("none", "fixed[4]", "fixed[0][0]", "fixed", "one.a.b", "one.i[0]", "names[0]", "one..a",
        "[0]", "fixed[", "one.i")) {
      assertEquals(OptionalDouble.empty(), decoded.number(path), path);
    }
  }

  @Test
  void sizesFollowFromArrays() throws RecordException {
    LcmRecord leaf = node.builder().text("name", "leaf").build();
    LcmRecord tree = node.builder().records("children", List.of(leaf, leaf)).text("name", "root").build();
    LcmRecord decoded = node.decode(node.encode(tree));
    assertEquals(OptionalDouble.of(2), decoded.number("num"));
    assertEquals(Optional.of("leaf"), decoded.text("children[1].name"));
    LcmRecord cube = arrays.builder().whole("n", 2).numbers("cube", new double[12]).build();
    assertEquals(OptionalDouble.of(3), cube.number("m"));
    assertEquals(3, ((LcmValue.Texts) cube.member("names").orElseThrow()).values().size());
  }

  @Test
  void whatDoesNotFitIsRefusedByName() {
    RecordBuilder builder = arrays.builder();
    refused("zoo.arrays_t has no member 'x'", () -> builder.whole("x", 1));
    refused("zoo.arrays_t.n is declared as 'int16_t n' and cannot hold Whole[value=40000]",
        () -> builder.whole("n", 40_000));
    refused("'float cube[n][2][m]'", () -> builder.whole("cube", 1));
    refused("2.5 is no byte", () -> builder.numbers("data", 2.5));
    refused("'zoo.scalars_t one'", () -> builder.record("one", node.builder().build()));
    refused("the shape of zoo.arrays_t.cube is open: set zoo.arrays_t.m or zoo.arrays_t.n",
        () -> arrays.builder().numbers("cube", 1, 2, 3, 4).build());
    refused("zoo.arrays_t.data has the shape [3], and its sizes say [2]",
        () -> arrays.builder().whole("n", 2).numbers("data", 1, 2, 3).build());
    refused("zoo.arrays_t.n is the size of an array and cannot be -1", () -> arrays.builder().whole("n", -1).build());
    refused("zoo.arrays_t.n is declared as 'int16_t n'",
        () -> arrays.builder().numbers("data", new double[40_000]).build());
    refused("a record of zoo.node_t is no zoo.arrays_t", () -> arrays.encode(node.builder().build()));
  }

  private static void refused(String reason, Runnable deed) {
    IllegalArgumentException e = assertThrows(IllegalArgumentException.class, deed::run);
    assertTrue(e.getMessage().contains(reason), e.getMessage());
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = """
      -1         | member num says that there are -1 elements, in member children, at byte 12
      2147483647 | an array of [2147483647] does not fit into the remaining 9 bytes, in member children, at byte 12
      1          | in member children[0].children, at byte 16
      """)
  void sizesThatLieAreRefusedWithTheirPlace(int size, String error) {
    ByteBuffer bytes =
        ByteBuffer.allocate(21).putLong(node.fingerprint()).putInt(size).putInt(77).put(new byte[5]).flip();
    RecordException e = assertThrows(RecordException.class, () -> node.decode(bytes));
    assertTrue(e.getMessage().startsWith("zoo.node_t: ") && e.getMessage().contains(error), e.getMessage());
  }

  @Test
  void aRecursionWithoutEndIsRefused() {
    ByteBuffer bytes = ByteBuffer.allocate(100_000).putLong(node.fingerprint());
    while (bytes.hasRemaining()) {
      bytes.putInt(1);
    }
    RecordException e = assertThrows(RecordException.class, () -> node.decode(bytes.flip()));
    assertEquals("structs are nested deeper than 200", e.problem());
  }

  @Test
  void anotherTypeIsNamedByItsFingerprint() {
    ByteBuffer bytes = node.encode(node.builder().build());
    RecordException e = assertThrows(RecordException.class, () -> arrays.decode(bytes));
    assertTrue(
        e.getMessage().contains("zoo.arrays_t: the fingerprint is 0xa911de693d846b9a and not 0xc26c4df508582d8e"),
        e.getMessage());
    RecordException unknown = assertThrows(RecordException.class, () -> zoo.decode(ByteBuffer.allocate(8)));
    assertTrue(unknown.getMessage().contains("0x0000000000000000 is that of none of the 9 known types"),
        unknown.getMessage());
    RecordException cut = assertThrows(RecordException.class, () -> zoo.decode(ByteBuffer.allocate(7)));
    assertTrue(cut.getMessage().contains("a message of 7 bytes has no fingerprint"), cut.getMessage());
  }
}
