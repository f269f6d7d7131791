package org.robotui.lcm.internal.udpm;

/** A datagram that is none of LCM, or none that is accepted. */
final class DatagramException extends Exception {

  private static final long serialVersionUID = 1L;

  DatagramException(String message) {
    super(message);
  }
}
