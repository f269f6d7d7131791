package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.message.ros.std_msgs.Header;

/** CDR against the bytes that rosbags writes, and against damage. */
class CdrTest {

  private static final int ROUNDS = 200;

  static List<CdrVectors.Vector> vectors() {
    return CdrVectors.all();
  }

  @ParameterizedTest
  @MethodSource("vectors")
  void messagesOfAnyTypeAreReadInBothOrdersAndWrittenAgain(CdrVectors.Vector vector) throws Exception {
    MessageSchema schema = ShippedDefinitions.schema(vector.type(), Generation.ROS2);
    DynamicMessage little = DynamicMessage.read(schema, new CdrReader(ByteBuffer.wrap(vector.little())));
    assertEquals(little, DynamicMessage.read(schema, new CdrReader(ByteBuffer.wrap(vector.big()))));
    for (ByteOrder order : List.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN)) {
      CdrWriter out = new CdrWriter(order);
      little.write(out);
      assertSame(order == ByteOrder.LITTLE_ENDIAN ? vector.little() : vector.big(), out.toByteArray());
    }
  }

  @ParameterizedTest
  @MethodSource("vectors")
  void aRecordHoldsTheSameOfBothGenerations(CdrVectors.Vector vector) throws Exception {
    same(vector, ShippedRecords.binding(vector.type(), Generation.ROS2),
        vector.ros1().isPresent() ? ShippedRecords.binding(vector.type(), Generation.ROS1)
            : null);
  }

  private static <T extends Record> void same(CdrVectors.Vector vector, RecordBinding<T> cdr,
      RecordBinding<? extends Record> ros1)
      throws MessageException {
    T value = cdr.decode(ByteBuffer.wrap(vector.little()));
    if (ShippedRecords.isComplete(vector.type())) {
      assertSame(vector.little(), CdrVectors.array(cdr.encode(value)));
    }
    assertArrayEquals(CdrVectors.array(cdr.encode(value)),
        CdrVectors.array(cdr.encode(cdr.decode(ByteBuffer.wrap(vector.big())))));
    if (ros1 != null) {
      @SuppressWarnings("unchecked")
      RecordBinding<T> old = (RecordBinding<T>) ros1;
      assertArrayEquals(CdrVectors.array(old.encode(value)),
          CdrVectors.array(old.encode(old.decode(ByteBuffer.wrap(vector.ros1().orElseThrow())))));
    }
  }

  /** The peer fills up the last word, as transports do. */
  private static void assertSame(byte[] expected, byte[] got) {
    assertTrue(expected.length - got.length >= 0 && expected.length - got.length < 4,
        expected.length + " " + got.length);
    assertArrayEquals(expected, Arrays.copyOf(got, expected.length));
  }

  @ParameterizedTest
  @MethodSource("vectors")
  void damagedMessagesAreRefusedOrRead(CdrVectors.Vector vector) throws Exception {
    SplittableRandom random = new SplittableRandom(18);
    MessageSchema schema = ShippedDefinitions.schema(vector.type(), Generation.ROS2);
    RecordBinding<?> binding = ShippedRecords.binding(vector.type(), Generation.ROS2);
    for (int round = 0; round < ROUNDS; round++) {
      byte[] damaged = damage(round % 2 == 0 ? vector.little() : vector.big(), random);
      boolean accepted = accepts(() -> DynamicMessage.read(schema, new CdrReader(ByteBuffer.wrap(damaged))));
      assertEquals(accepted, accepts(() -> binding.decode(ByteBuffer.wrap(damaged))), vector.type());
    }
  }

  /** Reads something. */
  private interface Read {
    Object read() throws MessageException;
  }

  private static boolean accepts(Read read) {
    try {
      read.read();
      return true;
    } catch (MessageException e) {
      return false;
    }
  }

  private static byte[] damage(byte[] original, SplittableRandom random) {
    byte[] bytes = original.clone();
    switch (random.nextInt(3)) {
      case 0 -> bytes = Arrays.copyOf(bytes, random.nextInt(bytes.length + 8));
      case 1 -> ByteBuffer.wrap(bytes).putInt(random.nextInt(bytes.length - 3),
          random.nextBoolean() ? -1 : 1 << random.nextInt(31));
      default -> bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
    }
    return bytes;
  }

  @Test
  void aHeaderLacksItsCounterAndTimesAreSigned() throws Exception {
    RecordBinding<Header> binding = RecordBinding.shipped(Header.class, Generation.ROS2);
    Header header = new Header(7, -1, "map");
    assertEquals(new Header(0, -1, "map"), binding.decode(binding.encode(header)));
  }

  @Test
  void otherEncapsulationsAreRefused() {
    MessageException e =
        assertThrows(MessageException.class, () -> new CdrReader(ByteBuffer.wrap(new byte[]{0, 3, 0, 0, 1})));
    assertEquals("the encapsulation 0x0003 is not that of CDR, version 1 at byte 0", e.getMessage());
    assertThrows(MessageException.class, () -> new CdrReader(ByteBuffer.wrap(new byte[]{0, 1, 0})));
  }

  @Test
  void boundsOfTheDefinitionHoldBeforeMemoryIsTaken() throws Exception {
    MessageSchema schema = MessageSchema.parse("p/msg/Bounded",
        "float64[<=2] few\nstring<=3 short\nwstring wide\nint32[<=3] some [1, -2]\nstring named \"a # b\"\nbool[] flags",
        Generation.ROS2);
    DynamicCodec codec = new DynamicCodec(schema);
    DynamicMessage message =
        codec.build(Map.of("few", List.of(1, 2), "short", "abc", "wide", "ä€𝄞", "flags", List.of(true, false)));
    assertEquals(-2, message.number("some[1]").orElseThrow());
    assertEquals("a # b", message.text("named").orElseThrow());
    CdrWriter out = new CdrWriter();
    message.write(out);
    assertEquals(message, DynamicMessage.read(schema, new CdrReader(out.view())));
    assertThrows(MessageException.class, () -> codec.build(Map.of("few", List.of(1, 2, 3))));
    assertThrows(MessageException.class, () -> codec.build(Map.of("short", "äb€")));
    byte[] more = out.toByteArray();
    ByteBuffer.wrap(more).order(ByteOrder.LITTLE_ENDIAN).putInt(CdrReader.HEADER, 3);
    MessageException e =
        assertThrows(MessageException.class, () -> DynamicMessage.read(schema, new CdrReader(ByteBuffer.wrap(more))));
    assertTrue(e.getMessage().startsWith("a length of 3 is more than the 2 of the definition in field few"),
        e.getMessage());
  }

  @Test
  void definitionsOfRos2AreReadAsItsGeneratorReadsThem() throws Exception {
    MessageDefinition d = DefinitionParser.parse("my_pkg/msg/Thing", """
        string NAME="a=b"   # constant
        int8 LOW=-1
        std_msgs/msg/Header header
        builtin_interfaces/Time[] times
        string<=10[<=5] names
        uint8[16] id
        int32 count 5 # five
        """, Generation.ROS2);
    assertEquals("my_pkg/Thing", d.type());
    assertEquals("a=b", d.constants().getFirst().value());
    assertEquals(
        List.of("std_msgs/Header header", "time[] times", "string<=10[<=5] names", "uint8[16] id", "int32 count"),
        d.fields().stream().map(f -> f.type() + " " + f.name()).toList());
    assertEquals("5", d.fields().getLast().initial().orElseThrow());
    for (String wrong : List.of("Part<=3 x", "int32<=3 x", "string<=0 x", "int32[<=] x", "wstring<=a x")) {
      assertThrows(DefinitionException.class, () -> DefinitionParser.parse("p/T", wrong, Generation.ROS2), wrong);
    }
    assertEquals(1, DefinitionParser.parse("p/T", "int8 ONLY=1", Generation.ROS2).fields().size());
    assertThrows(DefinitionException.class, () -> DefinitionParser.parse("p/T", "string<=3 x", Generation.ROS1));
  }
}
