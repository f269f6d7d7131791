package org.robotui.rtps.internal.discovery;

import java.net.InetAddress;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.rtps.ParticipantLimits;

/**
 * How much of peers is remembered: of all, of each machine, so that one that sends nonsense leaves room for the others,
 * and of each participant. Guarded by the lock of its owner.
 */
final class DiscoveryRoom {

  /** Who was silent for so long, whatever its lease says, goes first when there is no more room. */
  static final long QUIET = 30_000_000_000L;

  private static final long ALL_BYTES = 64L << 20;

  private static final long HOST_BYTES = ALL_BYTES / 2;

  private static final long PARTICIPANT_BYTES = ALL_BYTES / 8;

  private static final int HOST_PART = 4;

  private final ParticipantLimits limits;

  private final Map<InetAddress, Long> hostBytes = new HashMap<>();

  private long bytes;

  DiscoveryRoom(ParticipantLimits limits) {
    this.limits = limits;
  }

  /** Notes that somebody takes more or less. */
  void change(InetAddress host, long more) {
    bytes += more;
    if (hostBytes.merge(host, more, Long::sum) <= 0) {
      hostBytes.remove(host);
    }
  }

  /** Why a participant of a machine is not taken, if it is not. */
  Optional<String> refusal(InetAddress host, long more, Collection<RemoteParticipant> all) {
    long ofHost = all.stream().filter(known -> known.host().equals(host)).count();
    int most = Math.max(1, limits.participants() / HOST_PART);
    if (ofHost >= most) {
      return Optional.of("it is one of more than %d participants of %s".formatted(most, host.getHostAddress()));
    }
    if (all.size() >= limits.participants()) {
      return Optional.of("there are %d participants already".formatted(all.size()));
    }
    return more(host, more);
  }

  /** Why an endpoint of a participant is not taken, if it is not. */
  Optional<String> refusal(RemoteParticipant participant, long more, boolean isNew) {
    if (isNew && participant.endpoints().size() >= limits.endpoints()) {
      return Optional.of("its participant has %d endpoints already".formatted(limits.endpoints()));
    }
    if (participant.endpointBytes() + more > PARTICIPANT_BYTES) {
      return Optional.of("the endpoints of its participant take more than %d bytes".formatted(PARTICIPANT_BYTES));
    }
    return more(participant.host(), more);
  }

  private Optional<String> more(InetAddress host, long more) {
    if (hostBytes.getOrDefault(host, 0L) + more > HOST_BYTES) {
      return Optional.of("what %s has takes more than %d bytes".formatted(host.getHostAddress(), HOST_BYTES));
    }
    if (bytes + more > ALL_BYTES) {
      return Optional.of("what all have takes more than %d bytes".formatted(ALL_BYTES));
    }
    return Optional.empty();
  }
}
