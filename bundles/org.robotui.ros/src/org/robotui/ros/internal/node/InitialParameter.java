package org.robotui.ros.internal.node;

import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.MethodCall;

/** A private parameter from the command line: set when the master is reached, and again when it forgot. */
record InitialParameter(GraphName node, GraphName key, XmlRpcValue value) implements Registration {

  @Override
  public String what() {
    return "parameter " + key;
  }

  @Override
  public Outcome<XmlRpcValue> register(RosApi master) {
    return master.call("setParam", XmlRpcValue.of(node.text()), XmlRpcValue.of(key.text()), value);
  }

  /** Parameters outlive their node, as with every ROS program. */
  @Override
  public Optional<MethodCall> farewell() {
    return Optional.empty();
  }

  @Override
  public boolean agreesWith(SystemState state) {
    return true;
  }

  @Override
  public void registered(XmlRpcValue answer) {
    // nothing to learn
  }
}
