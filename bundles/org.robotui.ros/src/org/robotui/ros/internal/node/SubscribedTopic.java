package org.robotui.ros.internal.node;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.MethodCall;

/** A topic this node subscribes to: one registration for all its subscribers. */
final class SubscribedTopic implements Registration {

  private final GraphName node;
  private final GraphName topic;
  private final String type;
  private final String uri;
  private final List<Subscription<?>> subscriptions = new ArrayList<>();
  private Set<String> publishers = Set.of();

  SubscribedTopic(GraphName node, GraphName topic, String type, String uri) {
    this.node = node;
    this.topic = topic;
    this.type = type;
    this.uri = uri;
  }

  synchronized void add(Subscription<?> subscription) {
    subscriptions.add(subscription);
    subscription.publishers(publishers);
  }

  /** Removes a subscriber; answers whether it was the last one. */
  synchronized boolean remove(Subscription<?> subscription) {
    subscriptions.remove(subscription);
    return subscriptions.isEmpty();
  }

  synchronized void publishers(Collection<String> uris) {
    publishers = Set.copyOf(new HashSet<>(uris));
    subscriptions.forEach(subscription -> subscription.publishers(publishers));
  }

  synchronized List<Subscription<?>> subscriptions() {
    return List.copyOf(subscriptions);
  }

  String type() {
    return type;
  }

  @Override
  public String what() {
    return "subscriber of " + topic;
  }

  @Override
  public Outcome<XmlRpcValue> register(RosApi master) {
    return master.call("registerSubscriber", XmlRpcValue.of(node.text()), XmlRpcValue.of(topic.text()),
        XmlRpcValue.of(type), XmlRpcValue.of(uri));
  }

  @Override
  public Optional<MethodCall> farewell() {
    return Optional.of(new MethodCall("unregisterSubscriber",
        List.of(XmlRpcValue.of(node.text()), XmlRpcValue.of(topic.text()), XmlRpcValue.of(uri))));
  }

  /**
   * Comparing the number of publishers finds updates that never reached us, as when peers cannot connect to this
   * machine.
   */
  @Override
  public synchronized boolean agreesWith(SystemState state) {
    return state.subscribers().getOrDefault(topic.text(), List.of()).contains(node.text())
        && state.publishers().getOrDefault(topic.text(), List.of()).size() == publishers.size();
  }

  @Override
  public void registered(XmlRpcValue answer) {
    publishers(GraphCodec.texts(answer));
  }
}
