package org.robotui.ros.internal.xmlrpc;

import java.io.IOException;

/** Bytes that are no XML-RPC, or no HTTP that carries it. */
public final class XmlRpcException extends IOException {

  private static final long serialVersionUID = 1L;

  public XmlRpcException(String message) {
    super(message);
  }
}
