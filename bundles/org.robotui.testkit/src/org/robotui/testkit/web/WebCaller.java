package org.robotui.testkit.web;

import java.nio.ByteBuffer;

/** What a server does with those who call. Calls come one at a time for each link, on a thread of its own. */
public interface WebCaller {

  /**
   * Somebody has called.
   *
   * @param link to whoever called
   */
  void opened(WebServerLink link);

  /**
   * A text has come.
   *
   * @param link by which
   * @param text the whole message
   */
  void text(WebServerLink link, String text);

  /**
   * Bytes have come.
   *
   * @param link by which
   * @param bytes the whole message
   */
  void binary(WebServerLink link, ByteBuffer bytes);

  /**
   * A link has ended.
   *
   * @param link which
   */
  void closed(WebServerLink link);
}
