package org.robotui.web;

import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpTimeoutException;
import java.net.http.WebSocketHandshakeException;
import java.nio.channels.UnresolvedAddressException;
import java.util.Optional;
import org.robotui.net.log.PeerText;

/** Why a link fails, in words for users: what Java says is often nothing but the name of an exception. */
final class WebFaults {

  private WebFaults() {}

  static String said(URI address, Throwable error) {
    return address + " " + reason(error);
  }

  static String reason(Throwable error) {
    for (Throwable each = error; each != null; each = each.getCause()) {
      switch (each) {
        case WebSocketHandshakeException refused -> {
          return Optional.ofNullable(refused.getResponse())
              .map(r -> "answers, but not as a WebSocket with one of our protocols (status " + r.statusCode() + ")")
              .orElse("answers, but not as a WebSocket with one of our protocols");
        }
        case UnresolvedAddressException unknown -> {
          return "names a host that cannot be found";
        }
        case HttpTimeoutException late -> {
          return "has not answered in time";
        }
        default -> {
          // look deeper
        }
      }
    }
    if (error instanceof ConnectException || error.getCause() instanceof ConnectException) {
      return "cannot be reached: nobody listens there, or the connection is refused";
    }
    return "broke: " + PeerText.brief(Optional.ofNullable(error.getMessage()).orElse(error.getClass().getSimpleName()));
  }
}
