package org.robotui.ros.internal.node;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.message.MessageInfo;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.LinkEvent;
import org.robotui.ros.LinkState;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.xmlrpc.MethodCall;

/**
 * A topic this node subscribes to: one registration and one link to each publisher for all its subscribers. A publisher
 * of rospy drops the link to a node when the same node makes another one for the same topic.
 */
final class SubscribedTopic implements Registration {

  private static final int MAX_LINKS = 1024;

  private final NodeContext context;
  private final GraphName topic;
  private final String type;
  private final String uri;
  private final List<Subscription<?>> subscriptions = new CopyOnWriteArrayList<>();
  private final Map<String, InLink> links = new HashMap<>();
  private Set<String> publishers = Set.of();
  private boolean closed;

  SubscribedTopic(NodeContext context, GraphName topic, String type, String uri) {
    this.context = context;
    this.topic = topic;
    this.type = type;
    this.uri = uri;
  }

  GraphName topic() {
    return topic;
  }

  /** Publishers that refused what others want are asked again at once. */
  synchronized void add(Subscription<?> subscription) {
    links.values().forEach(link -> link.delivery().expect(subscription));
    subscriptions.add(subscription);
    links.values().forEach(link -> link.joined(subscription));
    publishers(publishers);
  }

  /** Removes a subscriber; answers whether it was the last one. */
  synchronized boolean remove(Subscription<?> subscription) {
    subscriptions.remove(subscription);
    return subscriptions.isEmpty();
  }

  /** Takes the publishers the master lists; those it does not list stay while they are connected. */
  synchronized void publishers(Collection<String> uris) {
    publishers = Set.copyOf(new HashSet<>(uris));
    if (!closed) {
      links.forEach((known, link) -> {
        if (!publishers.contains(known)) {
          link.orphan();
        }
      });
      publishers.forEach(this::publisher);
    }
  }

  private void publisher(String publisher) {
    InLink known = links.get(publisher);
    if (known == null && isFull(publisher)) {
      return;
    }
    if (known == null) {
      InLink link = new InLink(context, this, publisher);
      links.put(publisher, link);
      link.start();
    } else {
      known.nudge();
    }
  }

  /** Each link has a thread: a master that lists publishers without end must not make as many. */
  private boolean isFull(String publisher) {
    boolean full = links.size() >= MAX_LINKS;
    if (full) {
      context.report(LinkEvent.Kind.SUBSCRIPTION, topic.text(), publisher, new LinkState.Closed(
          "topic " + topic + ": publisher " + publisher + ": there are more than " + MAX_LINKS + " publishers"));
    }
    return full;
  }

  /** Forgets a link that is over; under the lock under which the master's lists revive links. */
  synchronized boolean ended(InLink link, String publisher) {
    boolean over = link.isOver();
    if (over) {
      links.remove(publisher, link);
    }
    return over;
  }

  /** What publishers are asked for: any type where the subscribers want different ones. */
  ConnectionHeader request() {
    List<MessageInfo> wanted = subscriptions.stream().<MessageInfo>map(each -> each.codec().info()).toList();
    boolean same = wanted.stream().map(MessageInfo::md5).distinct().count() == 1;
    ConnectionHeader header = ConnectionHeader.of(context.name().text())
        .with(same ? wanted.getFirst() : MessageInfo.any()).with("topic", topic.text());
    return subscriptions.stream().anyMatch(each -> each.options().tcpNoDelay()) ? header.with("tcp_nodelay", "1")
        : header;
  }

  /** Those of now; may be used while others come and go. */
  List<Subscription<?>> subscriptions() {
    return subscriptions;
  }

  synchronized List<InLink> links() {
    return List.copyOf(links.values());
  }

  String type() {
    return type;
  }

  /** Ends all links; none is made any more. */
  void close() {
    synchronized (this) {
      closed = true;
    }
    links().forEach(InLink::close);
  }

  @Override
  public String what() {
    return "subscriber of " + topic;
  }

  @Override
  public Outcome<XmlRpcValue> register(RosApi master) {
    return master.call("registerSubscriber", XmlRpcValue.of(context.name().text()), XmlRpcValue.of(topic.text()),
        XmlRpcValue.of(type), XmlRpcValue.of(uri));
  }

  @Override
  public Optional<MethodCall> farewell() {
    return Optional.of(new MethodCall("unregisterSubscriber",
        List.of(XmlRpcValue.of(context.name().text()), XmlRpcValue.of(topic.text()), XmlRpcValue.of(uri))));
  }

  /**
   * Comparing the number of publishers finds updates that never reached us, as when peers cannot connect to this
   * machine.
   */
  @Override
  public synchronized boolean agreesWith(SystemState state) {
    return state.subscribers().getOrDefault(topic.text(), List.of()).contains(context.name().text())
        && state.publishers().getOrDefault(topic.text(), List.of()).size() == publishers.size();
  }

  @Override
  public void registered(XmlRpcValue answer) {
    publishers(GraphCodec.texts(answer));
  }
}
