package org.robotui.yarp.wire;

import java.util.Arrays;
import java.util.Optional;

/** How a connection carries messages. */
public enum YarpCarrier {
  /** Each message is acknowledged. */
  TCP("tcp", 0x1ee4),
  /** Nothing is acknowledged. */
  FAST_TCP("fast_tcp", 0x1e64),
  /** Datagrams to one port; what gets lost is not said again. */
  UDP("udp", 0x1e61),
  /** Datagrams to a group, which all that listen to it share. */
  MCAST("mcast", 0x1e62);

  private final String word;
  private final int specifier;

  YarpCarrier(String word, int specifier) {
    this.word = word;
    this.specifier = specifier;
  }

  /**
   * As YARP calls it.
   *
   * @return such as {@code fast_tcp}
   */
  public String word() {
    return word;
  }

  /**
   * The number in headers.
   *
   * @return of this carrier
   */
  int specifier() {
    return specifier;
  }

  /**
   * Whether who takes a message says so.
   *
   * @return of each message
   */
  public boolean acknowledges() {
    return this == TCP;
  }

  /**
   * Whether messages come in datagrams, after a handshake by TCP.
   *
   * @return false where the connection of the handshake carries them
   */
  public boolean datagrams() {
    return this == UDP || this == MCAST;
  }

  static Optional<YarpCarrier> of(int specifier) {
    return Arrays.stream(values()).filter(carrier -> carrier.specifier == specifier).findFirst();
  }
}
