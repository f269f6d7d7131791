package org.robotui.rfic.roboframe.internal.session;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.PayloadSource;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.topic.TopicGraph;
import org.robotui.roboframe.wire.BoardKey;

/**
 * The keys of an application at one moment. A key may be there twice: once as it is written and once as it is read.
 *
 * @param keys by the topics that they are here
 */
record RemoteBoard(Map<String, List<OfferedKey>> keys) {
  static final RemoteBoard EMPTY = new RemoteBoard(Map.of());

  /** How the values of keys are read that were there before is not found out again. */
  RemoteBoard with(List<BoardKey> said, PayloadFormats formats) {
    Map<PayloadSource, OfferedKey> before = new HashMap<>();
    all().forEach(each -> before.put(source(each.key()), each));
    Map<String, List<OfferedKey>> now = new TreeMap<>();
    for (BoardKey key : said) {
      PayloadSource source = source(key);
      OfferedKey offered = new OfferedKey(key,
          before.containsKey(source) ? before.get(source).format() : formats.of(source));
      now.merge(ReceptionRule.global(key.name()), List.of(offered),
          (first, again) -> Stream.concat(first.stream(), again.stream()).toList());
    }
    return new RemoteBoard(now);
  }

  private static PayloadSource source(BoardKey key) {
    return new PayloadSource("ros1", key.type(), "ros1msg", key.definition());
  }

  Stream<OfferedKey> all() {
    return keys.values().stream().flatMap(List::stream);
  }

  Optional<OfferedKey> written(String topic) {
    return keys.getOrDefault(topic, List.of()).stream().filter(OfferedKey::isWritten).findFirst();
  }

  Optional<OfferedKey> read(String topic) {
    return keys.getOrDefault(topic, List.of()).stream().filter(OfferedKey::isRead).findFirst();
  }

  Optional<OfferedKey> first(String topic) {
    return keys.getOrDefault(topic, List.of()).stream().findFirst();
  }

  TopicGraph graph() {
    Map<String, String> published = new TreeMap<>();
    Map<String, String> subscribed = new TreeMap<>();
    keys.keySet().forEach(topic -> {
      written(topic).ifPresent(each -> published.put(topic, each.format().type()));
      read(topic).ifPresent(each -> subscribed.put(topic, each.format().type()));
    });
    return new TopicGraph(published, subscribed);
  }
}
