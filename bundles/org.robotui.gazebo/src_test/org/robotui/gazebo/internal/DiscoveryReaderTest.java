package org.robotui.gazebo.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Ends;
import org.robotui.gazebo.internal.DiscoveryMessage.Kind;
import org.robotui.gazebo.internal.DiscoveryMessage.Scope;

/** Datagrams of the library of version 11, as its tools sent them on topic /foo of partition recorded. */
class DiscoveryReaderTest {
  private static List<byte[]> recorded() throws IOException {
    try (InputStream in = DiscoveryReaderTest.class.getResourceAsStream("datagrams.txt")) {
      return new String(in.readAllBytes(), StandardCharsets.US_ASCII).lines().map(HexFormat.of()::parseHex).toList();
    }
  }

  private static List<DiscoveryMessage> messages() throws IOException {
    List<DiscoveryMessage> all = new ArrayList<>();
    for (byte[] each : recorded()) {
      all.add(DiscoveryReader.read(each, each.length));
    }
    return all;
  }

  @Test
  void recordedDatagramsAreRead() throws IOException {
    Set<Kind> kinds = EnumSet.noneOf(Kind.class);
    for (DiscoveryMessage each : messages()) {
      assertEquals(10, each.version());
      assertEquals(36, each.process().length());
      kinds.add(each.kind());
      assertEquals(each.kind() == Kind.SUBSCRIBE, !each.topic().isEmpty());
    }
    assertTrue(kinds.containsAll(EnumSet.of(Kind.ADVERTISE, Kind.SUBSCRIBE, Kind.UNADVERTISE, Kind.HEARTBEAT,
        Kind.NEW_CONNECTION)), kinds::toString);
  }

  @Test
  void announcementsAreReadAndWrittenAgain() throws IOException {
    List<Announcement> said = messages().stream().flatMap(each -> each.subject().stream()).toList();
    Announcement first = said.getFirst();
    assertEquals("@/recorded@/foo", first.topic());
    assertEquals(Scope.ALL, first.scope());
    assertTrue(PeerAddress.isGood(first.address()), first.address());
    assertEquals(new Ends.Messages("unused", "ignition.msgs.StringMsg"), first.ends());
    for (DiscoveryMessage each : messages()) {
      byte[] written = DiscoveryWriter.write(each);
      assertEquals(each, DiscoveryReader.read(written, written.length));
    }
  }

  @Test
  void truncatedDatagramsAreRefused() throws IOException {
    for (byte[] each : recorded()) {
      for (int size = 0; size < each.length; size++) {
        byte[] part = Arrays.copyOf(each, size);
        assertThrows(IOException.class, () -> DiscoveryReader.read(part, part.length));
      }
    }
  }

  @Test
  void spoiledDatagramsEndInAnErrorOrInAMessage() throws IOException {
    Random random = new Random(1);
    List<byte[]> all = recorded();
    for (int i = 0; i < 20_000; i++) {
      byte[] spoiled = all.get(random.nextInt(all.size())).clone();
      for (int k = random.nextInt(3); k >= 0; k--) {
        spoiled[2 + random.nextInt(spoiled.length - 2)] = (byte) random.nextInt();
      }
      try {
        assertNotNull(DiscoveryReader.read(spoiled, spoiled.length).kind());
      } catch (IOException e) {
        assertNotNull(e.getMessage());
      }
    }
  }

  @Test
  void onlyNumericAddressesAreGood() {
    assertTrue(PeerAddress.isGood("tcp://10.0.0.1:65535"));
    for (String bad : List.of("tcp://10.0.0.1:65536", "tcp://host:1", "ipc:///x", "inproc://x", "tcp://*:1", "")) {
      assertTrue(!PeerAddress.isGood(bad), bad);
    }
  }
}
