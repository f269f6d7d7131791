package org.robotui.ros.internal.node;

import java.util.List;
import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.MethodCall;

/** A service this node offers, as the master should know it. */
record OfferedService(GraphName node, GraphName service, String rpcUri, String uri) implements Registration {

  @Override
  public String what() {
    return "service " + service;
  }

  @Override
  public Outcome<XmlRpcValue> register(RosApi master) {
    return master.call("registerService", XmlRpcValue.of(node.text()), XmlRpcValue.of(service.text()),
        XmlRpcValue.of(rpcUri), XmlRpcValue.of(uri));
  }

  @Override
  public Optional<MethodCall> farewell() {
    return Optional.of(new MethodCall("unregisterService",
        List.of(XmlRpcValue.of(node.text()), XmlRpcValue.of(service.text()), XmlRpcValue.of(rpcUri))));
  }

  /** A service has one provider: when another node took it over, taking it back would make the two quarrel for ever. */
  @Override
  public boolean agreesWith(SystemState state) {
    return !state.services().getOrDefault(service.text(), List.of()).isEmpty();
  }

  @Override
  public void registered(XmlRpcValue answer) {
    // nothing to learn
  }
}
