package org.robotui.rtps.internal.discovery;

import java.net.InetAddress;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.Qos;

/** A participant that is there, and its endpoints. The lock of those who keep it guards all but when it was heard. */
final class RemoteParticipant {

  /** One that says less would be found and lost all the time. */
  private static final long SHORTEST_LEASE = 1_000_000_000L;

  private final InetAddress host;

  private final Map<EntityId, EndpointInfo> endpoints = new LinkedHashMap<>();

  private ParticipantInfo info;

  private long endpointBytes;

  private volatile long heard;

  RemoteParticipant(ParticipantInfo info, InetAddress host, long now) {
    this.info = info;
    this.host = host;
    this.heard = now;
  }

  InetAddress host() {
    return host;
  }

  ParticipantInfo info() {
    return info;
  }

  void info(ParticipantInfo said) {
    info = said;
  }

  long heardNanos() {
    return heard;
  }

  void heard(long now) {
    heard = now;
  }

  long quiet(long now) {
    return now - heard;
  }

  /** How long it may be silent from now on; {@link Long#MAX_VALUE} for ever. */
  long left(long now) {
    Duration lease = info.lease();
    return Qos.infinite(lease) ? Long.MAX_VALUE : Math.max(SHORTEST_LEASE, lease.toNanos()) - quiet(now);
  }

  Map<EntityId, EndpointInfo> endpoints() {
    return endpoints;
  }

  void put(EndpointInfo endpoint) {
    remove(endpoint.guid().entity());
    endpoints.put(endpoint.guid().entity(), endpoint);
    endpointBytes += Weight.of(endpoint);
  }

  void remove(EntityId entity) {
    EndpointInfo old = endpoints.remove(entity);
    endpointBytes -= old == null ? 0 : Weight.of(old);
  }

  long endpointBytes() {
    return endpointBytes;
  }

  long bytes() {
    return endpointBytes + Weight.of(info);
  }
}
