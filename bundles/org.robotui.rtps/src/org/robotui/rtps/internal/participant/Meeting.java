package org.robotui.rtps.internal.participant;

import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.Sample;
import org.robotui.rtps.internal.discovery.DiscoveredParticipants;
import org.robotui.rtps.internal.discovery.EndpointCodec;
import org.robotui.rtps.internal.discovery.Admission;
import org.robotui.rtps.internal.discovery.ParticipantCodec;
import org.robotui.rtps.internal.endpoint.Change;
import org.robotui.rtps.internal.wire.WireException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Gets to know other participants and their ends, and lets them know ours. */
final class Meeting implements Hearing, DiscoveryListener {

  private static final Logger LOG = LoggerFactory.getLogger(Meeting.class);

  private final DiscoveredParticipants discovered;
  private final Peers peers;
  private final Attention attention;
  private final LogThrottle refusals = new LogThrottle();
  private Parts parts;

  /** What a participant that is met is given to. */
  record Parts(BuiltIns builtIns, Announcer announcer, Matching matching) {}

  Meeting(DiscoveredParticipants discovered, Peers peers, Attention attention) {
    this.discovered = discovered;
    this.peers = peers;
    this.attention = attention;
  }

  /** Begins; before this nothing is received. */
  void begin(Parts with) {
    parts = with;
    discovered.addListener(this);
    discovered.addListener(with.matching());
  }

  /** Something came of a participant. */
  void heard(GuidPrefix source) {
    discovered.heard(source, attention.now());
  }

  /** A participant announces itself, or that it goes. */
  void participant(GuidPrefix source, InetAddress host, Sample.Kind kind, ByteBuffer payload, Optional<Guid> key)
      throws WireException {
    if (kind != Sample.Kind.ALIVE) {
      discovered.left(key.orElse(Guid.participant(source)), source, "it said farewell");
      return;
    }
    ParticipantInfo info = ParticipantCodec.read(payload.duplicate());
    peers.put(info, host);
    if (discovered.announced(info, source, host, attention.now()) instanceof Admission.Refused refused) {
      forget(info.guid().prefix());
      refused(refused.reason());
    }
  }

  private void refused(String reason) {
    if (refusals.admit()) {
      LOG.warn("not taken: {} ({} so far)", PeerText.brief(reason), refusals.count());
    }
  }

  /** Unless it is there, or there again. */
  private void forget(GuidPrefix prefix) {
    if (discovered.participant(prefix).isEmpty()) {
      peers.remove(prefix);
    }
  }

  @Override
  public void participantFound(ParticipantInfo info) {
    peers.builtIn(info.guid().prefix()).ifPresentOrElse(destination -> {
      parts.announcer().announceTo(destination);
      parts.builtIns().connect(info, destination);
    }, () -> refused(info.guid() + " announces no address that is reached from here: " + info.metatraffic()));
  }

  @Override
  public void participantChanged(ParticipantInfo info) {
    peers.builtIn(info.guid().prefix()).ifPresent(destination -> {
      parts.builtIns().disconnect(info.guid().prefix());
      parts.builtIns().connect(info, destination);
    });
  }

  @Override
  public void participantLost(ParticipantInfo info, String reason) {
    parts.builtIns().disconnect(info.guid().prefix());
    forget(info.guid().prefix());
  }

  @Override
  public void endpoint(Guid writer, Change change, EndpointKind kind) {
    try {
      if (change.kind() == Sample.Kind.ALIVE) {
        if (discovered.endpointAnnounced(EndpointCodec.read(change.payload().duplicate(), kind),
            writer.prefix()) instanceof Admission.Refused refused) {
          refused(refused.reason());
        }
      } else {
        Guid gone = change.payload().hasRemaining() ? EndpointCodec.readKey(change.payload().duplicate())
            : change.instance().orElse(Guid.UNKNOWN);
        discovered.endpointLeft(gone, writer.prefix(), "it was closed");
      }
    } catch (WireException e) {
      refused("an endpoint of " + writer.prefix() + ": " + e.getMessage());
    }
  }

  @Override
  public void alive(Guid writer, Change change) {
    AliveMessage.read(change.payload()).filter(message -> message.participant().equals(writer.prefix()))
        .ifPresent(message -> parts.matching().alive(message.participant(), message.kind()));
  }
}
