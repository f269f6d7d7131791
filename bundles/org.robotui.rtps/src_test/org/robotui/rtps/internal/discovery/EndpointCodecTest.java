package org.robotui.rtps.internal.discovery;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.rtps.DataRepresentation;
import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Locator;
import org.robotui.rtps.Locators;
import org.robotui.rtps.Ownership;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reliability;
import org.robotui.rtps.internal.wire.Encapsulation;
import org.robotui.rtps.internal.wire.ParameterId;
import org.robotui.rtps.internal.wire.ParameterOutput;
import org.robotui.rtps.internal.wire.WireException;

class EndpointCodecTest {

  private static final GuidPrefix PREFIX = new GuidPrefix(0x1122334455667788L, 9);

  private static Guid guid(EndpointKind kind) {
    return new Guid(PREFIX, EntityId.user(5, kind, false));
  }

  @ParameterizedTest
  @EnumSource
  void all_that_can_be_said_is_read_as_it_was_written(EndpointKind kind) throws Exception {
    Qos qos = Qos.reliable(7).keepAll().with(Durability.TRANSIENT_LOCAL).with(Ownership.EXCLUSIVE)
        .withTimes(Duration.ofMillis(120), Duration.ofSeconds(3, 1)).withPartitions(List.of("", "left", "a*"))
        .with(Liveliness.MANUAL_BY_TOPIC, Duration.ofNanos(999_999_999))
        .withRepresentations(List.of(DataRepresentation.XCDR2, DataRepresentation.XCDR1));
    Locator place = Locator.udp(InetAddress.getByName("192.168.1.2"), 7411);
    EndpointInfo info = new EndpointInfo(guid(kind), kind, "rt/über", "x::y_", qos, ByteBuffer.wrap(new byte[3]),
        new Locators(List.of(place), List.of(Ports.group()).stream().map(it -> Locator.udp(it, 7401)).toList()),
        kind == EndpointKind.READER);

    for (ByteOrder order : List.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN)) {
      assertEquals(info, EndpointCodec.read(EndpointCodec.write(info, order), kind));
    }
  }

  private static ParameterOutput list(EndpointKind kind) {
    return new ParameterOutput(ByteOrder.LITTLE_ENDIAN).guid(ParameterId.ENDPOINT_GUID, guid(kind))
        .text(ParameterId.TOPIC_NAME, "t").text(ParameterId.TYPE_NAME, "y");
  }

  private static EndpointInfo read(ParameterOutput out, EndpointKind kind) throws WireException {
    return EndpointCodec.read(Encapsulation.PL_CDR.payload(out.finish()), kind);
  }

  private static String refusal(ParameterOutput out) {
    return assertThrows(WireException.class, () -> read(out, EndpointKind.WRITER)).getMessage();
  }

  @Test
  void of_whom_nothing_is_said_writers_are_reliable_and_readers_are_not() throws Exception {
    assertEquals(Qos.standard().with(Reliability.RELIABLE), read(list(EndpointKind.WRITER), EndpointKind.WRITER).qos());
    assertEquals(Qos.standard(), read(list(EndpointKind.READER), EndpointKind.READER).qos());
  }

  @Test
  void what_is_not_known_is_skipped_whatever_it_asks() throws Exception {
    ParameterOutput out = list(EndpointKind.WRITER).plain(0x8007, new byte[40]).plain(0x4123, new byte[4])
        .plain(0x0075, new byte[100]).smallNumbers(ParameterId.DATA_REPRESENTATION, List.of(77));

    assertEquals("t", read(out, EndpointKind.WRITER).topic());
  }

  @Test
  void nonsense_is_refused_with_a_reason() {
    assertEquals("parameter 0x001a: a reliability of 9",
        refusal(list(EndpointKind.WRITER).number(ParameterId.RELIABILITY, 9)));
    assertEquals("parameter 0x001d: a durability of -1",
        refusal(list(EndpointKind.WRITER).number(ParameterId.DURABILITY, -1)));
    assertEquals("parameter 0x0023: a duration of -2 s",
        refusal(list(EndpointKind.WRITER).numbers(ParameterId.DEADLINE, -2, 0)));
    assertEquals("parameter 0x0029: a list of 257, of at most 256",
        refusal(list(EndpointKind.WRITER).texts(ParameterId.PARTITION, java.util.Collections.nCopies(257, "p"))));
    assertEquals("parameter 0x0005: 1030 bytes, of at most 1025; here are 1032",
        refusal(list(EndpointKind.WRITER).text(ParameterId.TOPIC_NAME, "x".repeat(1029))));
    assertTrue(refusal(list(EndpointKind.READER)).startsWith("no WRITER has the GUID 11.22.33"));
    assertEquals("an endpoint without a topic or a type", refusal(new ParameterOutput(ByteOrder.BIG_ENDIAN)
        .guid(ParameterId.ENDPOINT_GUID, guid(EndpointKind.WRITER))));
  }

  @Test
  void a_long_parameter_of_xtypes_is_as_good_as_a_short_one() throws Exception {
    ByteBuffer payload = ByteBuffer.allocate(200).put(new byte[]{0, 2, 0, 0}).putShort((short) 0x005a)
        .putShort((short) 16).put(guid(EndpointKind.WRITER).bytes());
    payload.putShort((short) 0x3f01).putShort((short) 8).putInt(5).putInt(8).putInt(2).put(new byte[]{'t', 0, 0, 0});
    payload.putShort((short) 7).putShort((short) 8).putInt(2).put(new byte[]{'y', 0, 0, 0});
    payload.putShort((short) 1).putShort((short) 0).flip();

    assertEquals("t", EndpointCodec.read(payload, EndpointKind.WRITER).topic());
  }

  @Test
  void ports_are_those_of_the_specification() {
    assertEquals(7400, new Ports(0).metatrafficMulticast());
    assertEquals(7411, new Ports(0).userUnicast(0));
    assertEquals(7401, new Ports(0).userMulticast());
    assertEquals(17_914, new Ports(42).metatrafficUnicast(2));
    assertEquals("239.255.0.1:17900", new Ports(42).announcements().toString());
    assertEquals(62, new Ports(232).lastParticipantId());
    assertEquals(List.of(7410, 7412, 7414), new Ports(0).tried().boxed().limit(3).toList());
    assertThrows(IllegalArgumentException.class, () -> new Ports(232).userUnicast(63));
    assertThrows(IllegalArgumentException.class, () -> new Ports(233));
  }
}
