package org.robotui.ros.internal.master;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.robotui.ros.XmlRpcValue;

/** Which node publishes, subscribes and serves what. Tells subscribers of new publishers. Any thread may use it. */
final class Registry {

  private static final String ANY = "*";

  private record Provider(String node, String rpcUri) {}

  private final Notifier notifier;
  private final Map<String, String> nodes = new TreeMap<>();
  private final SortedMap<String, Set<String>> publishers = new TreeMap<>();
  private final SortedMap<String, Set<String>> subscribers = new TreeMap<>();
  private final SortedMap<String, Provider> services = new TreeMap<>();
  private final SortedMap<String, Set<String>> watchers = new TreeMap<>();
  private final SortedMap<String, String> types = new TreeMap<>();

  Registry(Notifier notifier) {
    this.notifier = notifier;
  }

  synchronized List<String> addPublisher(String node, String uri, String topic, String type) {
    arrive(node, uri);
    publishers.computeIfAbsent(topic, key -> new LinkedHashSet<>()).add(node);
    learn(topic, type);
    tellSubscribers(topic);
    return uris(subscribers, topic);
  }

  synchronized List<String> addSubscriber(String node, String uri, String topic, String type) {
    arrive(node, uri);
    subscribers.computeIfAbsent(topic, key -> new LinkedHashSet<>()).add(node);
    if (!types.containsKey(topic) && !type.equals(ANY)) {
      learn(topic, type);
    }
    return uris(publishers, topic);
  }

  synchronized void addService(String node, String uri, String service, String rpcUri) {
    arrive(node, uri);
    services.put(service, new Provider(node, rpcUri));
  }

  synchronized void addWatcher(String node, String uri, String key) {
    arrive(node, uri);
    watchers.computeIfAbsent(key, name -> new LinkedHashSet<>()).add(node);
  }

  synchronized boolean removePublisher(String node, String uri, String topic) {
    boolean removed = uri.equals(nodes.get(node)) && remove(publishers, topic, node);
    if (removed) {
      tellSubscribers(topic);
      leaveIfIdle(node);
    }
    return removed;
  }

  synchronized boolean removeSubscriber(String node, String uri, String topic) {
    boolean removed = uri.equals(nodes.get(node)) && remove(subscribers, topic, node);
    leaveIfIdle(node);
    return removed;
  }

  synchronized boolean removeService(String node, String service, String rpcUri) {
    boolean removed = services.remove(service, new Provider(node, rpcUri));
    leaveIfIdle(node);
    return removed;
  }

  synchronized boolean removeWatcher(String node, String uri, String key) {
    boolean removed = uri.equals(nodes.get(node)) && remove(watchers, key, node);
    leaveIfIdle(node);
    return removed;
  }

  synchronized Optional<String> node(String name) {
    return Optional.ofNullable(nodes.get(name));
  }

  synchronized Optional<String> service(String name) {
    return Optional.ofNullable(services.get(name)).map(Provider::rpcUri);
  }

  /** Topics with a publisher whose type is known, below a namespace. */
  synchronized XmlRpcValue published(String namespace) {
    List<XmlRpcValue> all = new ArrayList<>();
    publishers.keySet().stream()
        .filter(topic -> types.containsKey(topic) && MasterNames.contains(namespace, topic))
        .forEach(topic -> all.add(XmlRpcValue.ofTexts(List.of(topic, types.get(topic)))));
    return new XmlRpcValue.Array(all);
  }

  synchronized XmlRpcValue types() {
    List<XmlRpcValue> all = new ArrayList<>();
    types.forEach((topic, type) -> all.add(XmlRpcValue.ofTexts(List.of(topic, type))));
    return new XmlRpcValue.Array(all);
  }

  synchronized XmlRpcValue state() {
    SortedMap<String, Set<String>> providers = new TreeMap<>();
    services.forEach((service, provider) -> providers.put(service, Set.of(provider.node())));
    return XmlRpcValue.of(describe(publishers), describe(subscribers), describe(providers));
  }

  private static XmlRpcValue describe(SortedMap<String, Set<String>> registrations) {
    List<XmlRpcValue> all = new ArrayList<>();
    registrations.forEach((name, users) -> all.add(XmlRpcValue.of(XmlRpcValue.of(name), XmlRpcValue.ofTexts(users))));
    return new XmlRpcValue.Array(all);
  }

  /**
   * Tells all who wait for a parameter but the one that changed it: those of it or a namespace above it get the change,
   * those below it their own new value.
   */
  synchronized void parameterChanged(String key, XmlRpcValue value, ParameterTree tree, String changedBy) {
    watchers.forEach((watched, users) -> {
      if (MasterNames.contains(watched, key)) {
        tell(users, changedBy, key, value);
      } else if (MasterNames.contains(key, watched)) {
        tell(users, changedBy, watched, tree.get(watched).orElse(ParameterTree.EMPTY));
      }
    });
  }

  private void tell(Set<String> users, String except, String key, XmlRpcValue value) {
    users.stream().filter(node -> !node.equals(except))
        .forEach(node -> notifier.paramUpdate(nodes.get(node), key, value));
  }

  /** A node that comes with another address takes the name over: the old one is told to end and forgotten. */
  private void arrive(String node, String uri) {
    Optional<String> old = Optional.ofNullable(nodes.put(node, uri)).filter(known -> !known.equals(uri));
    if (old.isPresent()) {
      notifier.shutdown(old.get(), "new node registered with same name");
      forget(node);
    }
  }

  private void forget(String node) {
    List.copyOf(subscribers.keySet()).forEach(topic -> remove(subscribers, topic, node));
    List.copyOf(watchers.keySet()).forEach(key -> remove(watchers, key, node));
    services.values().removeIf(provider -> provider.node().equals(node));
    for (String topic : List.copyOf(publishers.keySet())) {
      if (remove(publishers, topic, node)) {
        tellSubscribers(topic);
      }
    }
  }

  private void leaveIfIdle(String node) {
    boolean busy = uses(publishers, node) || uses(subscribers, node) || uses(watchers, node)
        || services.values().stream().anyMatch(provider -> provider.node().equals(node));
    if (!busy) {
      nodes.remove(node);
    }
  }

  private static boolean uses(SortedMap<String, Set<String>> registrations, String node) {
    return registrations.values().stream().anyMatch(users -> users.contains(node));
  }

  private static boolean remove(SortedMap<String, Set<String>> registrations, String name, String node) {
    Set<String> users = registrations.getOrDefault(name, Set.of());
    boolean removed = users.contains(node) && users.remove(node);
    if (users.isEmpty()) {
      registrations.remove(name);
    }
    return removed;
  }

  private void learn(String topic, String type) {
    if (!type.equals(ANY) || !types.containsKey(topic)) {
      types.put(topic, type);
    }
  }

  private void tellSubscribers(String topic) {
    List<String> all = uris(publishers, topic);
    uris(subscribers, topic).forEach(uri -> notifier.publisherUpdate(uri, topic, all));
  }

  private List<String> uris(SortedMap<String, Set<String>> registrations, String name) {
    return registrations.getOrDefault(name, Set.of()).stream().map(nodes::get).toList();
  }
}
