package org.robotui.rtps.internal.discovery;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.stream.IntStream;
import org.robotui.rtps.Locator;
import org.robotui.rtps.ParticipantSettings;

/**
 * The ports by which participants find each other, as the specification computes them.
 *
 * @param domain 0 to 232
 */
public record Ports(int domain) {

  /** As many participants of a machine are tried where a peer is given without a port. */
  static final int TRIED = 32;

  private static final int BASE = 7400;

  private static final int PER_DOMAIN = 250;

  private static final int PER_PARTICIPANT = 2;

  private static final byte[] GROUP = {(byte) 239, (byte) 255, 0, 1};

  /** Checks the bounds. */
  public Ports {
    if (domain < 0 || domain > ParticipantSettings.MAX_DOMAIN) {
      throw new IllegalArgumentException("domain " + domain);
    }
  }

  private int base() {
    return BASE + PER_DOMAIN * domain;
  }

  /** Where participants are announced to all. */
  public int metatrafficMulticast() {
    return base();
  }

  /** Where samples go to all. */
  public int userMulticast() {
    return base() + 1;
  }

  /** Where a participant hears of others. */
  public int metatrafficUnicast(int participantId) {
    return checked(base() + 10 + PER_PARTICIPANT * participantId, participantId);
  }

  /** Where a participant gets samples. */
  public int userUnicast(int participantId) {
    return checked(base() + 11 + PER_PARTICIPANT * participantId, participantId);
  }

  private int checked(int port, int participantId) {
    if (participantId < 0 || participantId > ParticipantSettings.MAX_PARTICIPANT_ID || port > 0xffff) {
      throw new IllegalArgumentException("domain " + domain + " has no ports for participant id " + participantId);
    }
    return port;
  }

  /** The highest participant id for which there are ports: the last domain has fewer. */
  public int lastParticipantId() {
    return Math.min(ParticipantSettings.MAX_PARTICIPANT_ID, (0xffff - base() - 11) / PER_PARTICIPANT);
  }

  /** The ports by which the first participants of a machine hear of others. */
  public IntStream tried() {
    return IntStream.rangeClosed(0, Math.min(TRIED - 1, lastParticipantId())).map(this::metatrafficUnicast);
  }

  /** The group that all participants join. */
  public static InetAddress group() {
    try {
      return InetAddress.getByAddress(GROUP.clone());
    } catch (UnknownHostException e) {
      throw new IllegalStateException("four bytes are an address", e);
    }
  }

  /** Where participants are announced to all. */
  public Locator announcements() {
    return Locator.udp(group(), metatrafficMulticast());
  }
}
