package org.robotui.web;

import java.nio.ByteBuffer;

/** Hears what comes over a link, one call at a time, on the threads of the link. Calls must not block. */
public interface WebListener {

  /**
   * A text has come.
   *
   * @param text the whole message
   */
  void onText(String text);

  /**
   * Bytes have come.
   *
   * @param bytes the whole message, in an array of its own that nobody writes to again
   */
  void onBinary(ByteBuffer bytes);

  /**
   * A message was passed over.
   *
   * @param reason what was wrong with it, for users
   */
  void onSkipped(String reason);
}
