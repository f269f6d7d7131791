package org.robotui.rtps.internal.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.VendorId;

/** What real programs sent is read whole, and written again it is the same. */
class RecordedTest {

  private static final class Taken {
    private final List<Submessage.Exchanged> parts = new ArrayList<>();
    private final List<VendorId> vendors = new ArrayList<>();
    private final List<Long> times = new ArrayList<>();
  }

  /** For whom each datagram is, so that no part is left out. */
  private static Taken read(byte[] datagram) throws WireException {
    Taken taken = new Taken();
    GuidPrefix to = new GuidPrefix(0, 0);
    for (int at = 20; at + 4 <= datagram.length;) {
      ByteBuffer in = ByteBuffer.wrap(datagram).order(ByteOrder.LITTLE_ENDIAN);
      int length = Short.toUnsignedInt(in.getShort(at + 2));
      if (datagram[at] == SubmessageId.INFO_DST) {
        to = WireInput.prefix(in.position(at + 4));
      }
      at += length == 0 && datagram[at] != SubmessageId.INFO_TS ? datagram.length : 4 + length;
    }
    new DatagramReader(to).read(ByteBuffer.wrap(datagram), (context, part) -> {
      taken.parts.add(part);
      taken.vendors.add(context.vendor());
      taken.times.add(context.timestamp());
    });
    return taken;
  }

  private static Map<String, Long> kinds(Recorded peer) throws WireException {
    List<Submessage> all = new ArrayList<>();
    for (byte[] datagram : peer.datagrams()) {
      all.addAll(read(datagram).parts);
    }
    return all.stream().collect(Collectors.groupingBy(part -> part.getClass().getSimpleName(), TreeMap::new,
        Collectors.counting()));
  }

  @Test
  void all_parts_of_fast_dds_are_read() throws Exception {
    assertEquals(Map.of("AckNack", 41L, "Data", 178L, "DataFrag", 2L, "Heartbeat", 52L), kinds(Recorded.FAST_DDS));
  }

  @Test
  void all_parts_of_cyclone_dds_are_read() throws Exception {
    assertEquals(Map.of("AckNack", 78L, "Data", 59L, "DataFrag", 2L, "Heartbeat", 69L, "HeartbeatFrag", 1L),
        kinds(Recorded.CYCLONE_DDS));
  }

  @ParameterizedTest
  @EnumSource
  void the_vendor_and_a_plausible_time_are_known(Recorded peer) throws Exception {
    VendorId vendor = peer == Recorded.FAST_DDS ? VendorId.FAST_DDS : VendorId.CYCLONE_DDS;
    for (byte[] datagram : peer.datagrams()) {
      Taken taken = read(datagram);
      assertTrue(taken.vendors.stream().allMatch(vendor::equals));
      assertTrue(taken.times.stream().allMatch(
          time -> time == WireTime.NONE || time > 1_700_000_000_000_000_000L && time < 2_000_000_000_000_000_000L));
    }
  }

  @ParameterizedTest
  @EnumSource
  void what_is_written_again_reads_as_the_same_in_both_byte_orders(Recorded peer) throws Exception {
    int count = 0;
    for (byte[] datagram : peer.datagrams()) {
      for (Submessage.Exchanged part : read(datagram).parts) {
        assertEquals(List.of(part), RoundTripTest.written(part, ByteOrder.LITTLE_ENDIAN));
        if (!(part instanceof Submessage.Data data) || !data.inlineQos().hasRemaining()) {
          assertEquals(List.of(part), RoundTripTest.written(part, ByteOrder.BIG_ENDIAN));
        }
        count++;
      }
    }
    assertTrue(count > 100, count + " parts");
  }

  @ParameterizedTest
  @EnumSource
  void small_samples_are_the_strings_that_were_sent(Recorded peer) throws Exception {
    List<String> heard = new ArrayList<>();
    for (byte[] datagram : peer.datagrams()) {
      for (Submessage.Exchanged part : read(datagram).parts) {
        if (part instanceof Submessage.Data data && !data.writer().builtIn()) {
          string(data.payload()).ifPresent(heard::add);
        }
      }
    }
    assertTrue(heard.containsAll(List.of("kept", "hello 3", "hello 4", "hello 30")), heard::toString);
  }

  private static Optional<String> string(ByteBuffer payload) throws WireException {
    ByteBuffer in = payload.duplicate();
    assertEquals(Encapsulation.CDR, Encapsulation.read(in));
    String text = StandardCharsets.ISO_8859_1.decode(in.duplicate()).toString();
    return text.contains("hello") || text.contains("kept") && in.remaining() < 16
        ? Optional.of(ParameterValue.text(in, 100))
        : Optional.empty();
  }

  @Test
  void a_reply_of_fast_dds_names_its_request() throws Exception {
    List<InlineQos> related = new ArrayList<>();
    for (byte[] datagram : Recorded.FAST_DDS.datagrams()) {
      for (Submessage.Exchanged part : read(datagram).parts) {
        if (part instanceof Submessage.Data data && InlineQos.read(data.inlineQos()).related().isPresent()) {
          related.add(InlineQos.read(data.inlineQos()));
        }
      }
    }
    assertTrue(related.stream().anyMatch(qos -> qos.related().orElseThrow().sequence() == 1), related::toString);
  }

  @ParameterizedTest
  @EnumSource
  void fragments_hold_exactly_their_bytes(Recorded peer) throws Exception {
    int size = peer == Recorded.FAST_DDS ? 65324 : 1344;
    int fragments = 0;
    for (byte[] datagram : peer.datagrams()) {
      for (Submessage.Exchanged part : read(datagram).parts) {
        if (part instanceof Submessage.DataFrag frag) {
          assertEquals(size, frag.fragmentSize());
          long left = frag.sampleSize() - (frag.first() - 1) * size;
          assertEquals(Math.min(left, (long) frag.count() * size), frag.payload().remaining());
          fragments++;
        }
      }
    }
    assertTrue(fragments > 0);
  }
}
