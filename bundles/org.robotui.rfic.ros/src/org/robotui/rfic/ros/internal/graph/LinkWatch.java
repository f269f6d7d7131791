package org.robotui.rfic.ros.internal.graph;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.ros.LinkEvent;
import org.robotui.ros.LinkListener;
import org.robotui.ros.LinkState;

/** Remembers which subscriptions fail, and why. */
final class LinkWatch implements LinkListener {
  private final Map<String, Map<String, String>> failures = new ConcurrentHashMap<>();

  @Override
  public void onLink(LinkEvent event) {
    if (event.kind() != LinkEvent.Kind.SUBSCRIPTION) {
      return;
    }
    Map<String, String> ofTopic = failures.computeIfAbsent(event.name(), t -> new ConcurrentHashMap<>());
    switch (event.state()) {
      case LinkState.Failed f -> ofTopic.put(event.peer(), f.reason());
      case LinkState.Connecting c -> {}
      case LinkState.Connected c -> ofTopic.clear();
      case LinkState.Closed c -> ofTopic.remove(event.peer());
    }
  }

  /** Why messages of a topic do not come, where a link to one of its publishers failed. */
  Optional<String> failure(String topic) {
    return failures.getOrDefault(topic, Map.of()).values().stream().findFirst();
  }

  void forget(String topic) {
    failures.remove(topic);
  }
}
