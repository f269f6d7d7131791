package org.robotui.ros.internal.node;

import java.io.IOException;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentMap;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.ProtocolException;

/** What a node publishes, subscribes to and serves right now, by global name. */
final class NodeParts {

  private final ConcurrentMap<String, Publication<?>> publications = new ConcurrentHashMap<>();
  private final ConcurrentMap<String, ServiceEndpoint<?, ?>> services = new ConcurrentHashMap<>();
  private final Map<String, SubscribedTopic> topics = new ConcurrentHashMap<>();

  /** Adds a publication unless there is one. */
  boolean add(Publication<?> publication) {
    return publications.putIfAbsent(publication.topic().text(), publication) == null;
  }

  void remove(Publication<?> publication) {
    publications.remove(publication.topic().text(), publication);
  }

  /** Adds a service unless there is one. */
  boolean add(ServiceEndpoint<?, ?> service) {
    return services.putIfAbsent(service.name().text(), service) == null;
  }

  void remove(ServiceEndpoint<?, ?> service) {
    services.remove(service.name().text(), service);
  }

  Map<String, SubscribedTopic> topics() {
    return topics;
  }

  Optional<Publication<?>> publication(String topic) {
    return Optional.ofNullable(publications.get(topic));
  }

  Collection<Publication<?>> publications() {
    return publications.values();
  }

  Collection<ServiceEndpoint<?, ?>> services() {
    return services.values();
  }

  List<Subscription<?>> subscriptions() {
    return topics.values().stream().<Subscription<?>>flatMap(topic -> topic.subscriptions().stream()).toList();
  }

  void publisherUpdate(String topic, List<String> uris) {
    Optional.ofNullable(topics.get(topic)).ifPresent(subscribed -> subscribed.publishers(uris));
  }

  /** Hands an accepted connection to the topic or service its header names. */
  void serve(TcpServer.Connection connection) throws IOException {
    ConnectionHeader header = connection.header();
    Optional<String> service = header.field("service");
    if (service.isPresent()) {
      service(service.get()).serve(connection);
    } else {
      String topic = header.require("topic");
      publication(topic).orElseThrow(() -> new ProtocolException("this node does not publish " + topic))
          .serve(connection.socket(), connection.in(), header);
    }
  }

  private ServiceEndpoint<?, ?> service(String name) throws ProtocolException {
    return Optional.ofNullable(services.get(name))
        .orElseThrow(() -> new ProtocolException("this node does not offer service " + name));
  }

  void close() {
    publications.values().forEach(Publication::close);
    services.values().forEach(ServiceEndpoint::close);
    subscriptions().forEach(Subscription::close);
  }
}
