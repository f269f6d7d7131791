package org.robotui.lcm.internal.udpm;

/** The numbers of LCM's UDP multicast protocol. All are sent big-endian. */
final class Wire {

  /** The first word of a message in one datagram: "LC02". */
  static final int SHORT = 0x4c433032;
  /** The first word of a fragment: "LC03". */
  static final int FRAGMENT = 0x4c433033;
  static final int SHORT_HEADER = 8;
  static final int FRAGMENT_HEADER = 20;
  /** What fits into one UDP datagram over IPv4. */
  static final int MOST_DATAGRAM = 65_507;
  static final int MOST_SHORT = MOST_DATAGRAM - SHORT_HEADER;
  static final int MOST_FRAGMENT = MOST_DATAGRAM - FRAGMENT_HEADER;
  static final int MOST_FRAGMENTS = 65_535;

  private Wire() {}
}
