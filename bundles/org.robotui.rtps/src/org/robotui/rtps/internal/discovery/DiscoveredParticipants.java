package org.robotui.rtps.internal.discovery;

import java.net.InetAddress;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.robotui.net.log.PeerText;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantLimits;
import org.robotui.rtps.ParticipantInfo;

/**
 * The participants that are there, with their endpoints. Nobody can say anything about others than itself. Safe for all
 * threads; listeners are told on the thread that calls, without a lock. Times are those of {@link System#nanoTime}.
 */
public final class DiscoveredParticipants {

  private final int domain;

  private final Map<GuidPrefix, RemoteParticipant> known = new ConcurrentHashMap<>();

  private final Listeners listeners = new Listeners();

  private final DiscoveryRoom room;

  /**
   * Knows nobody.
   *
   * @param domain who says to be of another one is refused
   * @param limits how many are remembered
   */
  public DiscoveredParticipants(int domain, ParticipantLimits limits) {
    this.domain = domain;
    this.room = new DiscoveryRoom(limits);
  }

  /**
   * A participant says that it is there.
   *
   * @param info what it says
   * @param source who sent the message
   * @param host from where the message came
   * @param now when
   * @return what became of it
   */
  public Admission announced(ParticipantInfo info, GuidPrefix source, InetAddress host, long now) {
    Admission outcome = take(info, source, host, now);
    listeners.tellAll();
    return outcome;
  }

  private synchronized Admission take(ParticipantInfo info, GuidPrefix source, InetAddress host, long now) {
    if (!info.guid().prefix().equals(source)) {
      return refused(info.guid(), "announced by " + source);
    }
    if (info.domain().isPresent() && info.domain().getAsInt() != domain) {
      return refused(info.guid(), "is of domain " + info.domain().getAsInt() + ", not of " + domain);
    }
    Optional<RemoteParticipant> old = Optional.ofNullable(known.get(source));
    if (old.isEmpty()) {
      return takeNew(new RemoteParticipant(info, host, now), now);
    }
    old.get().heard(now);
    if (old.get().info().equals(info)) {
      return new Admission.Known();
    }
    room.change(old.get().host(), Weight.of(info) - Weight.of(old.get().info()));
    old.get().info(info);
    listeners.queue(listener -> listener.participantChanged(info));
    return new Admission.Changed();
  }

  private Admission takeNew(RemoteParticipant newcomer, long now) {
    ParticipantInfo info = newcomer.info();
    Optional<String> refusal = room.refusal(newcomer.host(), newcomer.bytes(), known.values());
    if (refusal.isPresent() && forgetQuietest(newcomer.host(), now)) {
      refusal = room.refusal(newcomer.host(), newcomer.bytes(), known.values());
    }
    if (refusal.isPresent()) {
      return refused(info.guid(), refusal.get());
    }
    room.change(newcomer.host(), newcomer.bytes());
    known.put(info.guid().prefix(), newcomer);
    listeners.queue(listener -> listener.participantFound(info));
    return new Admission.Found();
  }

  /** Of the same machine first: what it has too much of is its own. */
  private boolean forgetQuietest(InetAddress host, long now) {
    Comparator<RemoteParticipant> order = Comparator.comparing((RemoteParticipant one) -> one.host().equals(host))
        .thenComparing(one -> one.quiet(now));
    Optional<RemoteParticipant> quietest =
        known.values().stream().filter(one -> one.quiet(now) > DiscoveryRoom.QUIET).max(order);
    quietest.ifPresent(one -> forget(one, "not heard for " + one.quiet(now) / 1_000_000_000L
        + " s while there is no room for others"));
    return quietest.isPresent();
  }

  private static Admission refused(Guid whom, String reason) {
    return new Admission.Refused(whom + ": " + reason);
  }

  /**
   * Something came from a participant, which renews its lease. Cheap enough for each datagram.
   *
   * @param source who sent it
   * @param now when
   */
  public void heard(GuidPrefix source, long now) {
    RemoteParticipant participant = known.get(source);
    if (participant != null) {
      participant.heard(now);
    }
  }

  /**
   * When something came from a participant last.
   *
   * @param source which one
   * @return when; empty if it is not known
   */
  public OptionalLong heardNanos(GuidPrefix source) {
    RemoteParticipant participant = known.get(source);
    return participant == null ? OptionalLong.empty() : OptionalLong.of(participant.heardNanos());
  }

  /**
   * A participant says that it goes.
   *
   * @param gone which one
   * @param source who sent the message; nobody else is believed
   * @param reason for a person to read
   */
  public void left(Guid gone, GuidPrefix source, String reason) {
    if (gone.equals(Guid.participant(source))) {
      forgetAll(Stream.of(source), reason);
    }
  }

  private void forgetAll(Stream<GuidPrefix> gone, String reason) {
    synchronized (this) {
      gone.map(known::get).filter(participant -> participant != null).forEach(one -> forget(one, reason));
    }
    listeners.tellAll();
  }

  private void forget(RemoteParticipant gone, String reason) {
    known.remove(gone.info().guid().prefix());
    room.change(gone.host(), -gone.bytes());
    for (EndpointInfo endpoint : gone.endpoints().values()) {
      listeners.queue(listener -> listener.endpointLost(endpoint, "its participant: " + reason));
    }
    ParticipantInfo info = gone.info();
    listeners.queue(listener -> listener.participantLost(info, reason));
  }

  /**
   * Forgets who was not heard for its lease.
   *
   * @param now what time it is
   * @return in how many nanoseconds the next one goes if it is not heard; {@link Long#MAX_VALUE} if there is none
   */
  public long expire(long now) {
    long next;
    synchronized (this) {
      for (RemoteParticipant participant : List.copyOf(known.values())) {
        if (participant.left(now) <= 0) {
          forget(participant, "not heard for its lease of " + participant.info().lease().toMillis() + " ms");
        }
      }
      next = known.values().stream().mapToLong(participant -> participant.left(now)).min().orElse(Long.MAX_VALUE);
    }
    listeners.tellAll();
    return next;
  }

  /**
   * A participant says that it has an endpoint.
   *
   * @param endpoint what it says
   * @param source who sent the message
   * @return what became of it
   */
  public Admission endpointAnnounced(EndpointInfo endpoint, GuidPrefix source) {
    Admission outcome = take(endpoint, source);
    listeners.tellAll();
    return outcome;
  }

  private synchronized Admission take(EndpointInfo endpoint, GuidPrefix source) {
    RemoteParticipant participant = known.get(source);
    if (participant == null || !endpoint.guid().prefix().equals(source) || endpoint.guid().entity().builtIn()) {
      return refused(endpoint.guid(), participant == null ? "its participant is not known" : "announced by " + source);
    }
    EndpointInfo old = participant.endpoints().get(endpoint.guid().entity());
    if (endpoint.equals(old)) {
      return new Admission.Known();
    }
    long more = Weight.of(endpoint) - (old == null ? 0 : Weight.of(old));
    Optional<String> refusal = room.refusal(participant, more, old == null);
    if (refusal.isPresent()) {
      return refused(endpoint.guid(), "%s: %s".formatted(PeerText.name(endpoint.topic()), refusal.get()));
    }
    room.change(participant.host(), more);
    participant.put(endpoint);
    if (old == null) {
      listeners.queue(listener -> listener.endpointFound(endpoint));
      return new Admission.Found();
    }
    listeners.queue(listener -> listener.endpointChanged(endpoint));
    return new Admission.Changed();
  }

  /**
   * A participant says that it has an endpoint no longer.
   *
   * @param gone which one
   * @param source who sent the message; nobody else is believed
   * @param reason for a person to read
   */
  public void endpointLeft(Guid gone, GuidPrefix source, String reason) {
    synchronized (this) {
      RemoteParticipant participant = known.get(source);
      EndpointInfo endpoint = participant == null ? null : participant.endpoints().get(gone.entity());
      if (endpoint != null && endpoint.guid().equals(gone)) {
        room.change(participant.host(), -Weight.of(endpoint));
        participant.remove(gone.entity());
        listeners.queue(listener -> listener.endpointLost(endpoint, reason));
      }
    }
    listeners.tellAll();
  }

  /** The participants that are there. */
  public synchronized List<ParticipantInfo> participants() {
    return known.values().stream().map(RemoteParticipant::info).toList();
  }

  /** One of them. */
  public synchronized Optional<ParticipantInfo> participant(GuidPrefix prefix) {
    return Optional.ofNullable(known.get(prefix)).map(RemoteParticipant::info);
  }

  /** All endpoints of all participants. */
  public synchronized List<EndpointInfo> endpoints() {
    return known.values().stream().flatMap(one -> one.endpoints().values().stream()).toList();
  }

  /** One of them. */
  public synchronized Optional<EndpointInfo> endpoint(Guid guid) {
    return Optional.ofNullable(known.get(guid.prefix())).map(one -> one.endpoints().get(guid.entity()));
  }

  /** Adds a listener, which is told first of all that is there, on this thread unless another one is telling. */
  public void addListener(DiscoveryListener listener) {
    synchronized (this) {
      listeners.add(listener, known.values().stream().flatMap(DiscoveredParticipants::asFound).toList());
    }
    listeners.tellAll();
  }

  private static Stream<Consumer<DiscoveryListener>> asFound(RemoteParticipant participant) {
    ParticipantInfo info = participant.info();
    Stream<Consumer<DiscoveryListener>> first = Stream.of(listener -> listener.participantFound(info));
    return Stream.concat(first, List.copyOf(participant.endpoints().values()).stream()
        .map(endpoint -> listener -> listener.endpointFound(endpoint)));
  }

  /** Removes a listener; it hears at most what is just being told. */
  public void removeListener(DiscoveryListener listener) {
    listeners.remove(listener);
  }
}
