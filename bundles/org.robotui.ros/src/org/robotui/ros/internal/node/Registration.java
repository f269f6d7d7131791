package org.robotui.ros.internal.node;

import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.MethodCall;

/** One thing the master should know about this node. */
interface Registration {

  /** For messages: what is registered. */
  String what();

  Outcome<XmlRpcValue> register(RosApi master);

  /** What the master is to be told at the end; nothing where what was registered outlives the node. */
  Optional<MethodCall> farewell();

  default Outcome<XmlRpcValue> unregister(RosApi master) {
    return farewell().map(master::call).orElseGet(() -> new Outcome.Done<>(XmlRpcValue.of(0)));
  }

  /** Whether the master's view, as far as it shows this registration, agrees with ours. */
  boolean agreesWith(SystemState state);

  /** Takes what the master answered. */
  void registered(XmlRpcValue answer);
}
