package org.robotui.core.internal.port;

/** Is told that an offer was closed. */
@FunctionalInterface
public interface Withdrawal {
  /** Takes it out of the table. */
  void withdrawn(Offered offered);
}
