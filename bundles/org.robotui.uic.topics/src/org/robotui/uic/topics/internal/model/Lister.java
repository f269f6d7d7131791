package org.robotui.uic.topics.internal.model;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallException;
import org.robotui.api.port.Input.Candidate;
import org.robotui.api.port.SourceId;
import org.robotui.ui.ask.StreamNames;
import org.robotui.uic.topics.internal.model.Catalog.Answered;

/**
 * Asks the robots what they have. Blocks; for one background thread. A robot that does not answer keeps what it said
 * before, with the reason.
 */
final class Lister {
  private final Map<String, Map<Kind, List<Item>>> said = new HashMap<>();
  private Catalog last = Catalog.NOTHING;

  /** What there is now; the same object as before where nothing changed. */
  Catalog list(List<BrowseInput.Robot> robots, List<Candidate> streams) {
    said.keySet().retainAll(robots.stream().map(robot -> robot.source().component()).toList());
    List<Answered> answers = new ArrayList<>();
    Map<Kind, List<Entry>> entries = new EnumMap<>(Kind.class);
    Map<String, List<SourceId>> byRobot =
        streams.stream().map(Candidate::id).collect(Collectors.groupingBy(SourceId::component));
    for (BrowseInput.Robot robot : robots) {
      String name = robot.source().component();
      Optional<String> failure = ask(robot);
      answers.add(new Answered(name, said.containsKey(name), failure));
      add(entries, name, byRobot.getOrDefault(name, List.of()));
    }
    Catalog next = Catalog.of(answers, entries);
    last = next.same(last) ? last : next;
    return last;
  }

  private Optional<String> ask(BrowseInput.Robot robot) {
    try {
      Map<Kind, List<Item>> items = new EnumMap<>(Kind.class);
      for (Kind kind : Catalog.KINDS) {
        items.put(kind, robot.browser().list(kind));
      }
      said.put(robot.source().component(), items);
      return Optional.empty();
    } catch (CallException e) {
      return Optional.of(e.getMessage());
    }
  }

  private void add(Map<Kind, List<Entry>> entries, String robot, List<SourceId> streams) {
    Map<Kind, List<Item>> items = said.getOrDefault(robot, Map.of());
    StreamNames names =
        StreamNames.of(items.getOrDefault(Kind.TOPIC, List.of()).stream().map(Item::name).toList(), streams);
    items.forEach((kind, list) -> {
      List<Entry> all = entries.computeIfAbsent(kind, k -> new ArrayList<>());
      list.forEach(item -> all.add(new Entry(new Key(robot, kind, item.name()), item.type(),
          kind == Kind.TOPIC ? names.find(item.name()) : Optional.empty())));
    });
  }
}
