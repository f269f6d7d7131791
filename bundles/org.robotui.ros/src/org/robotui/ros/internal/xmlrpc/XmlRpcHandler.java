package org.robotui.ros.internal.xmlrpc;

import org.robotui.ros.XmlRpcValue;

/** Answers calls; several connections may call at once. */
@FunctionalInterface
public interface XmlRpcHandler {

  XmlRpcValue handle(MethodCall call) throws XmlRpcFault;
}
