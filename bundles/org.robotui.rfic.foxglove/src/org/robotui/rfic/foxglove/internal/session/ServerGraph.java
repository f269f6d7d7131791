package org.robotui.rfic.foxglove.internal.session;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.topic.TopicGraph;
import org.robotui.message.topic.TopicSettings;

/** Who else publishes and subscribes what, as far as a server says it. */
final class ServerGraph {
  private ServerGraph() {}

  /**
   * The graph now. The type of a topic that is only subscribed is known where the configuration says it.
   *
   * @param hidden topics whose ports would have the name of one of ours
   */
  static TopicGraph of(ChannelTable table, Optional<Map<String, Set<String>>> subscribers, TopicSettings settings,
      Set<String> hidden) {
    Map<String, String> types = new TreeMap<>();
    settings.commands().forEach((type, names) -> names.forEach(name -> types.put(settings.topic(name), type)));
    Map<String, String> published = new TreeMap<>();
    table.topics().stream().filter(topic -> !hidden.contains(topic))
        .forEach(topic -> published.put(topic, table.first(topic).orElseThrow().format().type()));
    types.putAll(published);
    Map<String, String> subscribed = new TreeMap<>();
    subscribers.orElse(Map.of()).keySet().stream().filter(types::containsKey)
        .forEach(topic -> subscribed.put(topic, types.get(topic)));
    return new TopicGraph(published, subscribed);
  }

  /**
   * By global names, without topics that nobody has and without the server, which subscribes for its clients.
   *
   * @param ends of topics by the server's names
   */
  static Map<String, Set<String>> others(Map<String, Set<String>> ends, String server) {
    Set<String> itself = Set.of(server, "/" + server);
    Map<String, Set<String>> others = new HashMap<>();
    ends.forEach((topic, ids) -> {
      List<String> rest = ids.stream().filter(id -> !itself.contains(id)).toList();
      if (!rest.isEmpty()) {
        others.put(ReceptionRule.global(topic), rest.stream().collect(Collectors.toSet()));
      }
    });
    return others;
  }
}
