package org.robotui.gazebo.internal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.gazebo.GazeboGraph;
import org.robotui.gazebo.OfferedService;
import org.robotui.gazebo.OfferedTopic;
import org.robotui.gazebo.QualifiedName;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Ends;

/** What the processes of a partition have. Safe for all threads. */
final class GraphState {
  private final String partition;
  private final Map<Announcement, OfferedTopic> topics = new LinkedHashMap<>();
  private final Map<Announcement, OfferedService> services = new LinkedHashMap<>();
  private final Map<Announcement, OfferedTopic> subscriptions = new LinkedHashMap<>();

  GraphState(String partition) {
    this.partition = new QualifiedName(partition, "/x").text();
  }

  /** Takes note of it; answers whether it is new, of this partition. */
  synchronized boolean found(Announcement said) {
    if (topics.containsKey(said) || services.containsKey(said) || !PeerAddress.isGood(said.address())) {
      return false;
    }
    topic(said).ifPresent(topic -> topics.put(said, topic));
    service(said).ifPresent(service -> services.put(said, service));
    return topics.containsKey(said) || services.containsKey(said);
  }

  synchronized boolean lost(Announcement said) {
    return topics.remove(said) != null | services.remove(said) != null;
  }

  synchronized boolean connected(Announcement said) {
    return topic(said).filter(topic -> subscriptions.put(said, topic) == null).isPresent();
  }

  synchronized boolean disconnected(Announcement said) {
    return subscriptions.remove(said) != null;
  }

  /** How many nodes receive a topic that is published by a process. */
  synchronized int subscribers(String topic, String type, String process) {
    Predicate<Ends> its = ends -> ends instanceof Ends.Messages(String control, String wanted)
        && control.equals(process) && (wanted.equals(type) || wanted.equals("google.protobuf.Message"));
    return (int) subscriptions.keySet().stream().filter(each -> each.topic().equals(topic) && its.test(each.ends()))
        .count();
  }

  synchronized GazeboGraph graph(List<String> processes) {
    return new GazeboGraph(List.copyOf(topics.values()), List.copyOf(services.values()),
        List.copyOf(subscriptions.values()), processes);
  }

  /** Those that publish a topic. */
  synchronized List<Announcement> publishers(String topic) {
    return topics.keySet().stream().filter(each -> each.topic().equals(topic)).toList();
  }

  private Optional<QualifiedName> name(Announcement said) {
    return QualifiedName.parse(said.topic())
        .filter(name -> new QualifiedName(name.partition(), "/x").text().equals(partition));
  }

  private Optional<OfferedTopic> topic(Announcement said) {
    return name(said).flatMap(name -> said.ends() instanceof Ends.Messages messages
        ? Optional.of(new OfferedTopic(name, messages.type(), said.address(), said.process(), said.node()))
        : Optional.empty());
  }

  private Optional<OfferedService> service(Announcement said) {
    return name(said).flatMap(name -> said.ends() instanceof Ends.Requests ends
        ? Optional.of(new OfferedService(name, ends.request(), ends.response(), said.address(), ends.socket(),
            said.process(), said.node()))
        : Optional.empty());
  }
}
