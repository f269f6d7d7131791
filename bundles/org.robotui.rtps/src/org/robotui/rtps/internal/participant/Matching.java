package org.robotui.rtps.internal.participant;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Qos;
import org.robotui.rtps.internal.discovery.DiscoveredParticipants;
import org.robotui.rtps.internal.endpoint.Destination;

/**
 * Brings our ends and those of others together. Its lock guards what is matched with what; it is held while ends are
 * connected, never while listeners are told. Safe for all threads.
 */
final class Matching implements DiscoveryListener {

  /** Within the participant samples are in fragments of no more than this. */
  private static final int WITHIN = 65_000;

  private final DiscoveredParticipants discovered;
  private final Peers peers;
  private final Publishing publishing;
  private final List<LocalEndpoint> ours = new CopyOnWriteArrayList<>();
  private final MatchNotices notices = new MatchNotices();
  private boolean closed;

  /** Tells others of our ends. */
  interface Publishing {

    /** There is one. */
    void opened(EndpointInfo endpoint);

    /** It is no more. */
    void closed(EndpointInfo endpoint);
  }

  Matching(DiscoveredParticipants discovered, Peers peers, Publishing publishing) {
    this.discovered = discovered;
    this.peers = peers;
    this.publishing = publishing;
  }

  MatchNotices notices() {
    return notices;
  }

  /** One of our ends is there. */
  void add(LocalEndpoint endpoint) {
    synchronized (this) {
      if (closed) {
        endpoint.end();
        throw new IllegalStateException("the participant is closed");
      }
      own(endpoint);
      ours.add(endpoint);
      discovered.endpoints().stream().filter(endpoint::concerns).forEach(remote -> evaluate(endpoint, remote));
    }
    publishing.opened(endpoint.info());
    notices.tell();
  }

  /** Both ends may be ours. */
  private void own(LocalEndpoint endpoint) {
    Destination here = new Destination(endpoint.info().guid().prefix(), List.of(), WITHIN);
    ours.stream().filter(other -> endpoint.concerns(other.info())).forEach(other -> {
      endpoint.evaluate(other.info(), here);
      other.evaluate(endpoint.info(), here);
    });
  }

  /** One of our ends is no more. */
  void remove(LocalEndpoint endpoint) {
    synchronized (this) {
      if (!ours.remove(endpoint)) {
        return;
      }
      endpoint.end();
      ours.forEach(other -> other.forget(endpoint.info().guid(), "it was closed"));
    }
    publishing.closed(endpoint.info());
    notices.tell();
  }

  private void evaluate(LocalEndpoint endpoint, EndpointInfo remote) {
    peers.of(remote).ifPresentOrElse(destination -> endpoint.evaluate(remote, destination),
        () -> endpoint.unreachable(remote));
  }

  @Override
  public void endpointFound(EndpointInfo remote) {
    synchronized (this) {
      // it may have gone again while this was on its way here
      if (discovered.endpoint(remote.guid()).isPresent()) {
        ours.stream().filter(each -> each.concerns(remote)).forEach(each -> evaluate(each, remote));
      }
    }
    notices.tell();
  }

  @Override
  public void endpointChanged(EndpointInfo remote) {
    endpointFound(remote);
  }

  @Override
  public void endpointLost(EndpointInfo remote, String reason) {
    synchronized (this) {
      ours.stream().filter(each -> each.concerns(remote)).forEach(each -> each.forget(remote.guid(), reason));
    }
    notices.tell();
  }

  /** A participant says that it is alive. */
  void alive(GuidPrefix participant, Liveliness kind) {
    for (LocalEndpoint each : ours) {
      if (each instanceof LocalReader reader) {
        reader.core().alive(participant, kind);
      }
    }
  }

  /** The shortest time in which one of our writers promises to be heard of; infinite if none does. */
  Duration shortestLease() {
    return ours.stream().filter(LocalWriter.class::isInstance).map(each -> each.info().qos())
        .filter(qos -> qos.liveliness() == Liveliness.AUTOMATIC).map(Qos::livelinessLease).min(Duration::compareTo)
        .orElse(Qos.INFINITE);
  }

  /** Ends all of ours. */
  void close() {
    synchronized (this) {
      closed = true;
      ours.forEach(LocalEndpoint::end);
      ours.clear();
    }
  }
}
