package org.robotui.rtps.internal.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Locator;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.SampleIdentity;
import org.robotui.rtps.VendorId;

/** What is written is read as the same, in both byte orders. */
class RoundTripTest {

  private static final GuidPrefix SENDER = new GuidPrefix(0x0102030405060708L, 0x090a0b0c);

  private static final GuidPrefix OWN = new GuidPrefix(0x1112131415161718L, 0x191a1b1c);

  private static final EntityId READER = new EntityId(0x01020304);

  private static final EntityId WRITER = new EntityId(0xf1f2f303);

  private static final ByteBuffer NONE = ByteBuffer.allocate(0);

  static List<Submessage> written(Submessage part, ByteOrder order) throws WireException {
    DatagramWriter writer = new DatagramWriter(SENDER, 70_000, order);
    assertTrue(writer.add(part));
    List<Submessage> read = new ArrayList<>();
    new DatagramReader(OWN).read(writer.finish(), (context, it) -> read.add(it));
    return read;
  }

  static Stream<ByteOrder> orders() {
    return Stream.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN);
  }

  private static List<Submessage.Exchanged> all(ByteOrder order) {
    InlineQos qos = new InlineQos(true, true, Optional.of(new SampleIdentity(new Guid(OWN, WRITER), 7L << 33)),
        Optional.of(new Guid(SENDER, READER)));
    SequenceSet set =
        new SequenceSet.Builder(1L << 40).add(1L << 40).add((1L << 40) + 31).add((1L << 40) + 255).build();
    ByteBuffer bytes = ByteBuffer.wrap(new byte[]{1, 2, 3, 4, 5, 6, 7, 8});
    return List.of(
        new Submessage.Data(READER, WRITER, 5L << 32, qos.bytes(order), Submessage.Content.KEY, bytes),
        new Submessage.Data(READER, WRITER, 1, NONE, Submessage.Content.SAMPLE, bytes),
        new Submessage.Data(READER, WRITER, 1, qos.bytes(order), Submessage.Content.NOTHING, NONE),
        new Submessage.DataFrag(READER, WRITER, 9, 3, 2, 4, 16, NONE, false, bytes),
        new Submessage.DataFrag(READER, WRITER, 9, 3, 2, 4, 15, qos.bytes(order), true, bytes.slice(0, 7)),
        new Submessage.Heartbeat(READER, WRITER, 1, 0, -1, true, false),
        new Submessage.Heartbeat(READER, WRITER, 3, 1L << 50, 7, false, true),
        new Submessage.HeartbeatFrag(READER, WRITER, 4, 4_000_000_000L, 8),
        new Submessage.AckNack(READER, WRITER, set, 9, true),
        new Submessage.AckNack(READER, WRITER, SequenceSet.none(0), 1, false),
        new Submessage.NackFrag(READER, WRITER, 2, new SequenceSet.Builder(5).add(5).add(40).build(), 3),
        new Submessage.Gap(READER, WRITER, 2, set));
  }

  @ParameterizedTest
  @MethodSource("orders")
  void each_part_is_read_as_it_was_written(ByteOrder order) throws Exception {
    for (Submessage.Exchanged part : all(order)) {
      assertEquals(List.of(part), written(part, order));
    }
  }

  @ParameterizedTest
  @MethodSource("orders")
  void what_is_said_about_parts_holds_for_those_that_follow(ByteOrder order) throws Exception {
    DatagramWriter writer = new DatagramWriter(SENDER, 1000, order);
    Locator place = Locator.udp(InetAddress.getByName("10.1.2.3"), 7411);
    Submessage beat = new Submessage.Heartbeat(READER, WRITER, 1, 2, 3, false, false);
    List<Submessage> parts = List.of(beat, new Submessage.InfoTimestamp(1_700_000_000_123_456_789L),
        new Submessage.InfoReply(List.of(place), List.of(place)), new Submessage.InfoDestination(OWN), beat,
        new Submessage.InfoTimestamp(WireTime.NONE), new Submessage.InfoDestination(SENDER), beat,
        new Submessage.InfoSource(new ProtocolVersion(2, 1), VendorId.CYCLONE_DDS, OWN), beat,
        new Submessage.InfoSource(new ProtocolVersion(2, 1), VendorId.CYCLONE_DDS, new GuidPrefix(5, 6)), beat);
    parts.forEach(part -> assertTrue(writer.add(part)));
    List<String> heard = new ArrayList<>();
    new DatagramReader(OWN).read(writer.finish(), (context, part) -> heard.add("%s %s %d %s".formatted(context.vendor(),
        context.source(), context.timestamp(), context.reply())));

    assertEquals(List.of("unknown vendor " + SENDER + " " + WireTime.NONE + " []",
        "unknown vendor " + SENDER + " 1700000000123456789 [10.1.2.3:7411]",
        "Cyclone DDS " + new GuidPrefix(5, 6) + " " + WireTime.NONE + " []"), heard);
  }

  @Test
  void a_writer_says_when_a_datagram_is_full() {
    DatagramWriter writer = new DatagramWriter(SENDER, 20 + 3 * 32, ByteOrder.LITTLE_ENDIAN);
    Submessage beat = new Submessage.Heartbeat(READER, WRITER, 1, 2, 3, false, false);

    assertTrue(writer.isEmpty());
    assertTrue(writer.add(beat) && writer.add(beat) && writer.add(beat));
    assertFalse(writer.add(beat));
    assertEquals(20 + 3 * 32, writer.finish().remaining());
    writer.reset();
    assertTrue(writer.isEmpty() && writer.add(beat));
    assertThrows(IllegalArgumentException.class, () -> writer.add(new Submessage.Data(READER, WRITER, 1, NONE,
        Submessage.Content.SAMPLE, ByteBuffer.allocate(100))));
  }

  @Test
  void a_payload_is_padded() throws Exception {
    Submessage.Data odd = new Submessage.Data(READER, WRITER, 1, NONE, Submessage.Content.SAMPLE,
        ByteBuffer.wrap(new byte[]{1, 2, 3, 4, 5}));

    Submessage.Data read = (Submessage.Data) written(odd, ByteOrder.LITTLE_ENDIAN).getFirst();
    assertEquals(ByteBuffer.wrap(new byte[]{1, 2, 3, 4, 5, 0, 0, 0}), read.payload());
  }

  @Test
  void a_set_knows_its_numbers() {
    SequenceSet set = new SequenceSet.Builder(10).add(10).add(12).add(300).add(9).build();

    assertTrue(set.contains(10) && !set.contains(11) && set.contains(12) && !set.contains(9) && !set.contains(300));
    assertEquals(13, set.end());
    assertEquals("10{ 10 12 }/3", set.toString());
    assertTrue(SequenceSet.none(4).isEmpty());
  }

  @Test
  void times_come_back_to_the_nanosecond() {
    for (long nanos : new long[]{0, 1, 999_999_999, 1_000_000_000, 1_764_000_000_000_000_001L, 333_333_333}) {
      assertEquals(nanos, WireTime.nanos(WireTime.seconds(nanos), WireTime.fraction(nanos)));
    }
    assertEquals(WireTime.NONE, WireTime.nanos(WireTime.seconds(WireTime.NONE), WireTime.fraction(WireTime.NONE)));
  }

  @Test
  void old_forms_of_places_for_answers_are_read() throws Exception {
    ByteBuffer message = ByteBuffer.allocate(100).putInt(0x52545053).putInt(0x02010103).put(new byte[12]);
    message.put((byte) SubmessageId.INFO_REPLY_IP4).put((byte) 0).putShort((short) 8).putInt(0x0a010203).putInt(7411);
    message.put((byte) SubmessageId.HEARTBEAT_FRAG).put((byte) 0).putShort((short) 0);
    message.putInt(READER.value()).putInt(WRITER.value()).putLong(1).putInt(2).putInt(3).flip();
    List<String> heard = new ArrayList<>();
    new DatagramReader(OWN).read(message, (context, part) -> heard.add(context.reply() + " " + context.vendor()));

    assertEquals(List.of("[10.1.2.3:7411] OpenDDS"), heard);
  }
}
