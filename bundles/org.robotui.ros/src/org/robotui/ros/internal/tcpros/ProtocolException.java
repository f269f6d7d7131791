package org.robotui.ros.internal.tcpros;

import java.io.IOException;

/** A peer sent what the protocol does not allow. */
public final class ProtocolException extends IOException {

  private static final long serialVersionUID = 1L;

  public ProtocolException(String message) {
    super(message);
  }

  public ProtocolException(String message, Throwable cause) {
    super(message, cause);
  }
}
