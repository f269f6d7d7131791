package org.robotui.rtps.internal.discovery;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.History;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.Reliability;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.internal.wire.InlineQos;
import org.robotui.rtps.internal.wire.DatagramReader;
import org.robotui.rtps.internal.wire.Recorded;
import org.robotui.rtps.internal.wire.Submessage;
import org.robotui.rtps.internal.wire.WireException;

/** What real programs said of themselves is understood. */
class RecordedDiscoveryTest {

  private final Map<Guid, ParticipantInfo> participants = new LinkedHashMap<>();

  private final Map<Guid, EndpointInfo> endpoints = new LinkedHashMap<>();

  private final Set<Guid> gone = new HashSet<>();

  /** As both participants heard it: messages to one of them are for no other. */
  private void hear(Recorded peer) throws WireException {
    Set<GuidPrefix> hearers = new HashSet<>();
    for (byte[] datagram : peer.datagrams()) {
      ByteBuffer in = ByteBuffer.wrap(datagram, 8, 12);
      hearers.add(new GuidPrefix(in.getLong(), in.getInt()));
    }
    assertEquals(2, hearers.size());
    for (GuidPrefix hearer : hearers) {
      for (byte[] datagram : peer.datagrams()) {
        List<Submessage.Data> heard = new ArrayList<>();
        new DatagramReader(hearer).read(ByteBuffer.wrap(datagram), (context, part) -> {
          if (part instanceof Submessage.Data data && data.writer().builtIn()) {
            heard.add(data);
          }
        });
        for (Submessage.Data data : heard) {
          take(data);
        }
      }
    }
  }

  private void take(Submessage.Data data) throws WireException {
    if (data.content() == Submessage.Content.NOTHING) {
      InlineQos said = InlineQos.read(data.inlineQos());
      assertTrue(said.disposed() && said.unregistered());
      gone.add(said.key().orElseThrow());
    } else if (data.writer().equals(BuiltIn.PARTICIPANT_WRITER)) {
      ParticipantInfo info = ParticipantCodec.read(data.payload());
      participants.put(info.guid(), info);
    } else if (data.writer().equals(BuiltIn.PUBLICATIONS_WRITER)) {
      put(EndpointCodec.read(data.payload(), EndpointKind.WRITER));
    } else if (data.writer().equals(BuiltIn.SUBSCRIPTIONS_WRITER)) {
      put(EndpointCodec.read(data.payload(), EndpointKind.READER));
    }
  }

  private void put(EndpointInfo info) {
    endpoints.put(info.guid(), info);
  }

  private List<EndpointInfo> of(EndpointKind kind, String topic) {
    return endpoints.values().stream().filter(info -> info.kind() == kind && info.topic().equals(topic)).toList();
  }

  private static String text(ByteBuffer bytes) {
    return StandardCharsets.UTF_8.decode(bytes).toString();
  }

  @Test
  void two_nodes_of_ros_2_on_fast_dds() throws Exception {
    hear(Recorded.FAST_DDS);

    assertEquals(2, participants.size());
    for (ParticipantInfo info : participants.values()) {
      assertEquals(VendorId.FAST_DDS, info.vendor());
      assertEquals("enclave=/;", text(info.userData()).replace("\0", ""));
      assertEquals(Duration.ofSeconds(20), info.lease());
      assertEquals(BuiltIn.OURS, info.builtInEndpoints() & BuiltIn.OURS);
      assertFalse(info.metatraffic().unicast().isEmpty() || info.userTraffic().unicast().isEmpty());
      assertTrue(gone.contains(info.guid()), "it said that it goes");
    }
    EndpointInfo chatter = of(EndpointKind.WRITER, "rt/chatter").getFirst();
    assertEquals("std_msgs::msg::dds_::String_", chatter.type());
    assertTrue(text(chatter.userData()).matches("typehash=RIHS01_[0-9a-f]{64};"));
    assertEquals(Reliability.RELIABLE, chatter.qos().reliability());
    assertEquals(Reliability.BEST_EFFORT, of(EndpointKind.WRITER, "rt/image").getFirst().qos().reliability());
    assertEquals(Reliability.BEST_EFFORT, of(EndpointKind.READER, "rt/image").getFirst().qos().reliability());
    assertEquals(Durability.TRANSIENT_LOCAL, of(EndpointKind.WRITER, "rt/latched").getFirst().qos().durability());
    assertEquals(1, of(EndpointKind.READER, "rq/switchRequest").size());
    assertEquals(2, of(EndpointKind.WRITER, "ros_discovery_info").size());
    assertTrue(endpoints.size() > 40, endpoints.size() + " endpoints");
  }

  @Test
  void two_programs_on_cyclone_dds() throws Exception {
    hear(Recorded.CYCLONE_DDS);

    assertEquals(2, participants.size());
    for (ParticipantInfo info : participants.values()) {
      assertEquals(VendorId.CYCLONE_DDS, info.vendor());
      assertEquals(Duration.ofSeconds(10), info.lease());
      assertEquals(BuiltIn.OURS, info.builtInEndpoints() & BuiltIn.OURS);
      assertFalse(info.metatraffic().unicast().isEmpty());
    }
    EndpointInfo chatter = of(EndpointKind.WRITER, "rt/chatter").getFirst();
    assertEquals("typehash=RIHS01_x;", text(chatter.userData()));
    assertEquals(Reliability.RELIABLE, chatter.qos().reliability());
    assertEquals(History.KEEP_LAST, chatter.qos().history());
    assertEquals(10, chatter.qos().depth());
    assertEquals(Durability.TRANSIENT_LOCAL, of(EndpointKind.READER, "rt/latched").getFirst().qos().durability());
    assertEquals(6, endpoints.size());
  }

  @ParameterizedTest
  @EnumSource
  void what_is_written_again_reads_as_the_same_in_both_byte_orders(Recorded peer) throws Exception {
    hear(peer);
    for (ByteOrder order : List.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN)) {
      for (ParticipantInfo info : participants.values()) {
        assertEquals(info, ParticipantCodec.read(ParticipantCodec.write(info, order)));
        assertEquals(info.guid(), EndpointCodec.readKey(EndpointCodec.writeKey(info.guid(), order)));
      }
      for (EndpointInfo info : endpoints.values()) {
        assertEquals(info, EndpointCodec.read(EndpointCodec.write(info, order), info.kind()));
        assertEquals(info.guid(), EndpointCodec.readKey(EndpointCodec.writeKey(info.guid(), order)));
      }
    }
  }
}
