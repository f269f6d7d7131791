package org.robotui.rtps;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.OptionalInt;

/**
 * How a participant takes part.
 *
 * @param domain which domain, 0 to 232; participants of others do not hear each other
 * @param participantId which set of ports, 0 to 119; empty: the first that is free
 * @param interfaces which network interfaces are used
 * @param multicast whether participants are looked for by multicast
 * @param peers machines that are asked one by one
 * @param name what others see of it; may be empty
 * @param userData bytes that others see of it; ROS 2 puts {@code enclave=/;} there
 * @param lease how long others take it to be there when they do not hear it
 * @param announcePeriod how often it says that it is there; less than a third of the lease, so that one may get lost
 * @param limits how much memory all peers may take together
 */
public record ParticipantSettings(int domain, OptionalInt participantId, Interfaces interfaces, boolean multicast,
    List<InitialPeer> peers, String name, ByteBuffer userData, Duration lease, Duration announcePeriod,
    ParticipantLimits limits) {

  /** The highest domain for which there are ports. */
  public static final int MAX_DOMAIN = 232;

  /** The highest participant id for which there are ports that no other domain has. */
  public static final int MAX_PARTICIPANT_ID = 119;

  /** Copies what could change and checks the bounds. */
  public ParticipantSettings {
    peers = List.copyOf(peers);
    userData = UserBytes.copy(userData);
    if (domain < 0 || domain > MAX_DOMAIN) {
      throw new IllegalArgumentException("domain " + domain + "; write 0 to " + MAX_DOMAIN);
    }
    int id = participantId.orElse(0);
    if (id < 0 || id > MAX_PARTICIPANT_ID) {
      throw new IllegalArgumentException("participant id " + id + "; write 0 to " + MAX_PARTICIPANT_ID);
    }
    if (announcePeriod.isNegative() || announcePeriod.isZero() || announcePeriod.multipliedBy(3).compareTo(lease) > 0) {
      throw new IllegalArgumentException("announced every " + announcePeriod + " with a lease of " + lease);
    }
  }

  /**
   * Loopback only, by multicast, any participant id, a lease of 3 s that is renewed every 750 ms: whoever waits for
   * this program while it is stopped waits no longer.
   *
   * @param domain which domain
   * @param name what others see of it
   * @return the settings
   */
  public static ParticipantSettings standard(int domain, String name) {
    return new ParticipantSettings(domain, OptionalInt.empty(), new Interfaces.Loopback(), true, List.of(), name,
        ByteBuffer.allocate(0), Duration.ofSeconds(3), Duration.ofMillis(750), ParticipantLimits.standard());
  }

  /**
   * The bytes that others see.
   *
   * @return a view of its own for each call
   */
  @Override
  public ByteBuffer userData() {
    return userData.duplicate();
  }

  /**
   * The same on other interfaces.
   *
   * @param used which ones
   * @return the changed settings
   */
  public ParticipantSettings withInterfaces(Interfaces used) {
    return new ParticipantSettings(domain, participantId, used, multicast, peers, name, userData, lease,
        announcePeriod, limits);
  }

  /**
   * The same with another way to find participants.
   *
   * @param group whether they are looked for by multicast
   * @param machines those that are asked one by one
   * @return the changed settings
   */
  public ParticipantSettings withPeers(boolean group, List<InitialPeer> machines) {
    return new ParticipantSettings(domain, participantId, interfaces, group, machines, name, userData, lease,
        announcePeriod, limits);
  }

  /**
   * The same with other bytes for others to see.
   *
   * @param bytes from position to limit
   * @return the changed settings
   */
  public ParticipantSettings withUserData(ByteBuffer bytes) {
    return new ParticipantSettings(domain, participantId, interfaces, multicast, peers, name, bytes, lease,
        announcePeriod, limits);
  }

  /**
   * The same with another lease.
   *
   * @param taken how long others take it to be there when they do not hear it
   * @param period how often it says that it is there
   * @return the changed settings
   */
  public ParticipantSettings withLease(Duration taken, Duration period) {
    return new ParticipantSettings(domain, participantId, interfaces, multicast, peers, name, userData, taken, period,
        limits);
  }

  /**
   * The same with other bounds.
   *
   * @param bounds how much memory all peers may take together
   * @return the changed settings
   */
  public ParticipantSettings withLimits(ParticipantLimits bounds) {
    return new ParticipantSettings(domain, participantId, interfaces, multicast, peers, name, userData, lease,
        announcePeriod, bounds);
  }
}
