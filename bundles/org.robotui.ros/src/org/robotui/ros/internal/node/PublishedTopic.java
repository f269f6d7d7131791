package org.robotui.ros.internal.node;

import java.util.List;
import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.MethodCall;

/** A topic this node publishes, as the master should know it. */
record PublishedTopic(GraphName node, GraphName topic, String type, String uri) implements Registration {

  @Override
  public String what() {
    return "publisher of " + topic;
  }

  @Override
  public Outcome<XmlRpcValue> register(RosApi master) {
    return master.call("registerPublisher", XmlRpcValue.of(node.text()), XmlRpcValue.of(topic.text()),
        XmlRpcValue.of(type), XmlRpcValue.of(uri));
  }

  @Override
  public Optional<MethodCall> farewell() {
    return Optional.of(new MethodCall("unregisterPublisher",
        List.of(XmlRpcValue.of(node.text()), XmlRpcValue.of(topic.text()), XmlRpcValue.of(uri))));
  }

  @Override
  public boolean agreesWith(SystemState state) {
    return state.publishers().getOrDefault(topic.text(), List.of()).contains(node.text());
  }

  @Override
  public void registered(XmlRpcValue answer) {
    // the master answers the subscribers, which come by themselves
  }
}
