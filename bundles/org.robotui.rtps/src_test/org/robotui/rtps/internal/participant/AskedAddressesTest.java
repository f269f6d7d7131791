package org.robotui.rtps.internal.participant;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.robotui.rtps.InitialPeer;
import org.robotui.rtps.Interfaces;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.internal.transport.Addresses;

class AskedAddressesTest {
  private static List<InetSocketAddress> asked(InitialPeer... peers) throws Exception {
    ParticipantSettings settings = ParticipantSettings.standard(5, "test").withInterfaces(new Interfaces.All());
    return AskedAddresses.of(settings.withPeers(false, List.of(peers)), Addresses.of(new Interfaces.All()));
  }

  @Test
  void whoeverHasANumberIsAskedAndCycloneThatHasNone() throws Exception {
    List<Integer> ports = asked(new InitialPeer("127.0.0.1", OptionalInt.empty())).stream()
        .map(InetSocketAddress::getPort).toList();
    assertTrue(ports.containsAll(List.of(8650, 8660, 8662)), ports.toString());
  }

  @Test
  void aPortThatIsNamedIsTheOnlyOne() throws Exception {
    assertEquals(List.of(new InetSocketAddress("127.0.0.1", 9)),
        asked(new InitialPeer("127.0.0.1", OptionalInt.of(9)), new InitialPeer("127.0.0.1", OptionalInt.of(9))));
  }

  @Test
  void anUnknownMachineKeepsNoOtherFromBeingAsked() throws Exception {
    assertEquals(List.of(new InetSocketAddress("127.0.0.1", 9)),
        asked(new InitialPeer("no such machine.invalid", OptionalInt.empty()),
            new InitialPeer("127.0.0.1", OptionalInt.of(9))));
  }
}
