package org.robotui.api.port;

/** Something offered until it is closed. */
public interface Offer extends AutoCloseable {
  /** Withdraws the offer; consumers are told. Further calls do nothing. */
  @Override
  void close();
}
