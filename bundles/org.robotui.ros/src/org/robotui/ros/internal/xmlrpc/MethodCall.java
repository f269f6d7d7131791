package org.robotui.ros.internal.xmlrpc;

import java.util.List;
import org.robotui.ros.XmlRpcValue;

/** A call as it travels: the method's name and its arguments. */
public record MethodCall(String method, List<XmlRpcValue> arguments) {

  public MethodCall {
    arguments = List.copyOf(arguments);
  }
}
