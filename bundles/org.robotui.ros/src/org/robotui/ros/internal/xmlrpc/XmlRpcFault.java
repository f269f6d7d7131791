package org.robotui.ros.internal.xmlrpc;

/** The peer answered with a fault: it understood the call and refused it. */
public final class XmlRpcFault extends Exception {

  private static final long serialVersionUID = 1L;

  private final int code;

  public XmlRpcFault(int code, String message) {
    super(message);
    this.code = code;
  }

  public int code() {
    return code;
  }
}
