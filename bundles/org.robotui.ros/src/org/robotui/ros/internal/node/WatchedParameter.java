package org.robotui.ros.internal.node;

import java.util.List;
import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.ParameterListener;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.MethodCall;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A parameter a listener waits for. */
final class WatchedParameter implements Registration {

  /** What masters say of a parameter that is not set. */
  static final XmlRpcValue UNSET = new XmlRpcValue.Struct(java.util.Map.of());

  private static final Logger LOG = LoggerFactory.getLogger(WatchedParameter.class);

  private final GraphName node;
  private final GraphName key;
  private final String uri;
  private final ParameterListener listener;

  WatchedParameter(GraphName node, GraphName key, String uri, ParameterListener listener) {
    this.node = node;
    this.key = key;
    this.uri = uri;
    this.listener = listener;
  }

  GraphName key() {
    return key;
  }

  void deliver(GraphName changed, XmlRpcValue value) {
    try {
      listener.onParameter(changed, value.equals(UNSET) ? Optional.empty() : Optional.of(value));
    } catch (RuntimeException e) {
      LOG.error("{}: listener of parameter {} failed", node, key, e);
    }
  }

  @Override
  public String what() {
    return "subscription of parameter " + key;
  }

  @Override
  public Outcome<XmlRpcValue> register(RosApi master) {
    return master.call("subscribeParam", XmlRpcValue.of(node.text()), XmlRpcValue.of(uri), XmlRpcValue.of(key.text()));
  }

  @Override
  public Optional<MethodCall> farewell() {
    return Optional.of(new MethodCall("unsubscribeParam",
        List.of(XmlRpcValue.of(node.text()), XmlRpcValue.of(uri), XmlRpcValue.of(key.text()))));
  }

  /** The system state shows no parameters; a restarted master is known by its run id. */
  @Override
  public boolean agreesWith(SystemState state) {
    return true;
  }

  @Override
  public void registered(XmlRpcValue answer) {
    deliver(key, answer);
  }
}
