package org.robotui.rtps.internal.participant;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Locator;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.internal.endpoint.Destination;
import org.robotui.rtps.internal.transport.Routes;

/** How other participants are reached. Safe for all threads. */
final class Peers {

  private final Routes routes;
  private final Map<GuidPrefix, InitialPeer> peers = new ConcurrentHashMap<>();

  /** What one says of itself, and from where it was heard first. */
  private record InitialPeer(ParticipantInfo info, InetAddress host) {}

  Peers(Routes routes) {
    this.routes = routes;
  }

  void put(ParticipantInfo info, InetAddress host) {
    peers.compute(info.guid().prefix(), (same, old) -> new InitialPeer(info, old == null ? host : old.host()));
  }

  void remove(GuidPrefix prefix) {
    peers.remove(prefix);
  }

  /** Where a participant's built-in endpoints are; empty if it cannot be reached. */
  Optional<Destination> builtIn(GuidPrefix prefix) {
    return Optional.ofNullable(peers.get(prefix)).flatMap(
        peer -> destination(prefix, peer.info().metatraffic().unicast(), peer.host()));
  }

  /** Where an endpoint is: as it says itself, else as its participant says. */
  Optional<Destination> of(EndpointInfo endpoint) {
    GuidPrefix prefix = endpoint.guid().prefix();
    return Optional.ofNullable(peers.get(prefix))
        .flatMap(peer -> destination(prefix, endpoint.locators().unicast(), peer.host())
            .or(() -> destination(prefix, peer.info().userTraffic().unicast(), peer.host())));
  }

  private Optional<Destination> destination(GuidPrefix prefix, List<Locator> unicast, InetAddress host) {
    Optional<InetSocketAddress> address = routes.choose(unicast, host);
    return address.map(to -> new Destination(prefix, List.of(to), routes.mostDatagram(to.getAddress())));
  }
}
