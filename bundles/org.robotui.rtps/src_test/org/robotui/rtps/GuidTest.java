package org.robotui.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class GuidTest {

  private static final byte[] BYTES = HexFormat.of().parseHex("010f5d2a0123456789abcdef000004c2");

  @Test
  void it_is_what_its_bytes_are() {
    Guid guid = Guid.of(ByteBuffer.wrap(BYTES));

    assertEquals("01.0f.5d.2a.01.23.45.67.89.ab.cd.ef|00.00.04.c2", guid.toString());
    assertEquals("010f5d2a0123456789abcdef000004c2", HexFormat.of().formatHex(guid.bytes()));
    assertEquals("01.0f.5d.2a.01.23.45.67.89.ab.cd.ef|00.00.01.c1", guid.participant().toString());
    assertThrows(IllegalArgumentException.class, () -> Guid.of(ByteBuffer.allocate(15)));
  }

  @Test
  void an_entity_says_what_it_is() {
    EntityId writer = EntityId.user(0x12, EndpointKind.WRITER, false);
    EntityId reader = EntityId.user(0x12, EndpointKind.READER, true);

    assertEquals("00.00.12.03", writer.toString());
    assertEquals("00.00.12.07", reader.toString());
    assertTrue(writer.writer() && !writer.reader() && !writer.keyed() && !writer.builtIn());
    assertTrue(reader.reader() && !reader.writer() && reader.keyed());
    assertTrue(new EntityId(0x0003c2).builtIn());
    assertFalse(EntityId.UNKNOWN.writer() || EntityId.UNKNOWN.reader());
  }

  @Test
  void they_are_in_the_order_of_their_bytes() {
    GuidPrefix low = new GuidPrefix(1, 0);
    GuidPrefix high = new GuidPrefix(-1, 0);

    assertTrue(low.compareTo(high) < 0);
    assertTrue(new Guid(low, new EntityId(-1)).compareTo(new Guid(low, new EntityId(1))) > 0);
  }

  @Test
  void a_locator_is_an_address_where_udp_reaches_it() throws Exception {
    Locator locator = Locator.udp(InetAddress.getByName("239.255.0.1"), 7400);

    assertEquals(Optional.of(new InetSocketAddress("239.255.0.1", 7400)), locator.socketAddress());
    assertEquals("239.255.0.1:7400", locator.toString());
    assertEquals(Optional.empty(), new Locator(16, 7400, 0, 0).socketAddress());
    assertEquals(Optional.empty(), new Locator(Locator.UDP_V4, 0, 0, 1).socketAddress());
    assertThrows(IllegalArgumentException.class, () -> Locator.udp(InetAddress.getByName("::1"), 7400));
  }

  @Test
  void aPrefixNamesTheVendorOfItsLibrary() {
    assertEquals(VendorId.FAST_DDS, new GuidPrefix(0x010f_dead_beef_0001L, 7).vendor());
    assertEquals("vendor 0xffff", new GuidPrefix(-1, 0).vendor().toString());
  }
}
