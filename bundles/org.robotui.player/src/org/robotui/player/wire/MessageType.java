package org.robotui.player.wire;

import java.util.Optional;

/** What a message is for. */
public enum MessageType {
  /** Measurements of a device. */
  DATA(1),
  /** What a device is to do; nobody answers. */
  COMMAND(2),
  /** A question to a device; it answers with {@link #ACK} or {@link #NACK}, or not at all. */
  REQUEST(3),
  /** The device did what it was asked. */
  ACK(4),
  /** The server's mark at the end of a round of data in pull mode. */
  SYNC(5),
  /** The device will not do what it was asked. */
  NACK(6);

  private final int code;

  MessageType(int code) {
    this.code = code;
  }

  /**
   * The number on the wire.
   *
   * @return from 1
   */
  public int code() {
    return code;
  }

  /**
   * Finds the type of a number on the wire.
   *
   * @param code the number
   * @return empty if no type has it
   */
  public static Optional<MessageType> of(int code) {
    return code < 1 || code > values().length ? Optional.empty() : Optional.of(values()[code - 1]);
  }
}
