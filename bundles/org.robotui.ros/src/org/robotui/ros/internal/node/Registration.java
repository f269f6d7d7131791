package org.robotui.ros.internal.node;

import org.robotui.ros.Outcome;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;

/** One thing the master should know about this node. */
interface Registration {

  /** For messages: what is registered. */
  String what();

  Outcome<XmlRpcValue> register(RosApi master);

  Outcome<XmlRpcValue> unregister(RosApi master);

  /** Whether the master's view, as far as it shows this registration, agrees with ours. */
  boolean agreesWith(SystemState state);

  /** Takes what the master answered. */
  void registered(XmlRpcValue answer);
}
