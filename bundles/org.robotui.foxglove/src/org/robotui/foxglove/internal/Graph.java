package org.robotui.foxglove.internal;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** Who publishes and subscribes what, put together from updates. For one thread at a time. */
public final class Graph {

  private static final int MOST = 20_000;

  private final Map<String, Set<String>> publishers = new HashMap<>();
  private final Map<String, Set<String>> subscribers = new HashMap<>();

  /** Takes the message {@code connectionGraphUpdate}. */
  public void update(Map<String, Object> message) throws TreeException {
    Trees.texts(message, "removedTopics").forEach(topic -> {
      publishers.remove(topic);
      subscribers.remove(topic);
    });
    update(message, "publishedTopics", "publisherIds", publishers);
    update(message, "subscribedTopics", "subscriberIds", subscribers);
  }

  private static void update(Map<String, Object> message, String list, String ids, Map<String, Set<String>> known)
      throws TreeException {
    for (Object item : Trees.list(message, list)) {
      Map<String, Object> topic = Trees.object(item);
      known.put(Trees.text(topic, "name"), Set.copyOf(Trees.texts(topic, ids)));
      if (known.size() > MOST) {
        throw new TreeException("a graph of more than " + MOST + " topics");
      }
    }
  }

  /** Who publishes, by topic. */
  public Map<String, Set<String>> publishers() {
    return Map.copyOf(publishers);
  }

  /** Who subscribes, by topic. */
  public Map<String, Set<String>> subscribers() {
    return Map.copyOf(subscribers);
  }

  /** A message that a client sends. */
  public static Map<String, Object> message(String op, String name, Object value) {
    Map<String, Object> message = new LinkedHashMap<>();
    message.put("op", op);
    message.put(name, value);
    return message;
  }
}
