package org.robotui.rtps.internal.participant;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.InitialPeer;
import org.robotui.rtps.internal.discovery.Ports;
import org.robotui.rtps.internal.transport.Addresses;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The addresses at which participants are asked for one by one. */
final class AskedAddresses {

  private static final Logger LOG = LoggerFactory.getLogger(AskedAddresses.class);

  private AskedAddresses() {}

  static List<InetSocketAddress> of(ParticipantSettings settings, Addresses addresses) {
    List<InitialPeer> peers = new ArrayList<>(settings.peers());
    if (addresses.loopbackOnly()) {
      // few machines have multicast on loopback
      peers.add(new InitialPeer("127.0.0.1", OptionalInt.empty()));
    }
    List<InetSocketAddress> asked = new ArrayList<>();
    for (InitialPeer peer : peers) {
      try {
        InetAddress host = InetAddress.getByName(peer.host());
        if (!addresses.loopbackOnly() || addresses.isOwn(host)) {
          ports(peer, settings.domain()).forEach(port -> asked.add(new InetSocketAddress(host, port)));
        } else {
          LOG.warn("{} is not asked, as nothing beyond loopback is used", peer.host());
        }
      } catch (UnknownHostException e) {
        LOG.warn("the peer {} is not known: {}", peer.host(), e.getMessage());
      }
    }
    return asked.stream().distinct().toList();
  }

  /** Cyclone DDS has no number, and so none of the ports for it, where it uses multicast; but it hears that port. */
  private static IntStream ports(InitialPeer peer, int domain) {
    Ports ports = new Ports(domain);
    return peer.port().isPresent() ? IntStream.of(peer.port().getAsInt())
        : IntStream.concat(IntStream.of(ports.metatrafficMulticast()), ports.tried());
  }
}
