package org.robotui.yarp.wire;

import java.util.Arrays;
import java.util.Optional;

/** How a connection carries messages. */
public enum YarpCarrier {
  /** Each message is acknowledged. */
  TCP("tcp", 0x1ee4),
  /** Nothing is acknowledged. */
  FAST_TCP("fast_tcp", 0x1e64);

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

  static Optional<YarpCarrier> of(int specifier) {
    return Arrays.stream(values()).filter(carrier -> carrier.specifier == specifier).findFirst();
  }
}
