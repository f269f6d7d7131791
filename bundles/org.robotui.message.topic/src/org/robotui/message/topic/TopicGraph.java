package org.robotui.message.topic;

import java.util.Map;

/**
 * Who else, beside this process, publishes and subscribes what, at one moment.
 *
 * @param published type by topic, of topics that others publish
 * @param subscribed type by topic, of topics to which others subscribe
 */
public record TopicGraph(Map<String, String> published, Map<String, String> subscribed) {
  /** Takes copies. */
  public TopicGraph {
    published = Map.copyOf(published);
    subscribed = Map.copyOf(subscribed);
  }
}
