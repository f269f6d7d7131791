package org.robotui.web;

import java.net.URI;
import java.util.List;
import java.util.Optional;

/** Addresses of servers. */
public final class WebAddress {

  private static final List<String> SCHEMES = List.of("ws", "wss");

  private WebAddress() {}

  /**
   * Judges a text.
   *
   * @param text such as {@code ws://robot:8765}
   * @return empty where it is an address; else what is wrong, which may be nothing in particular
   */
  public static Optional<String> fault(String text) {
    try {
      URI url = URI.create(text);
      boolean good = SCHEMES.contains(String.valueOf(url.getScheme())) && url.getHost() != null;
      return good ? Optional.empty() : Optional.of("");
    } catch (IllegalArgumentException e) {
      return Optional.of("");
    }
  }
}
