package org.robotui.rosbridge;

/** Hears what a bridge says beside messages, on the threads of the link. Calls must not block. */
public interface BridgeListener {

  /**
   * Something came that nobody can read, and it was ignored.
   *
   * @param reason for users
   */
  void onUnreadable(String reason);

  /**
   * The bridge tells what it thinks of what it was told.
   *
   * @param level such as {@code error} or {@code warning}
   * @param message what it tells
   */
  default void onStatus(String level, String message) {}
}
