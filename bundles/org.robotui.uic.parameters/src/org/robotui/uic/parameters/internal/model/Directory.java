package org.robotui.uic.parameters.internal.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.port.BrowseInput.Robot;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallException;

/**
 * What parameters and tunable programs robots have, as they last said.
 *
 * @param trees one for each robot that has answered
 * @param servers the programs whose settings can be changed while they run
 * @param failures why robots did not answer, by robot
 * @param asked who was asked
 */
record Directory(List<Branch> trees, List<Key> servers, Map<String, String> failures, List<String> asked) {
  static final Directory NOTHING = new Directory(List.of(), List.of(), Map.of(), List.of());

  int parameters() {
    return trees.stream().mapToInt(Branch::leaves).sum();
  }

  /** The robots that have answered. */
  Set<String> known() {
    return trees.stream().map(tree -> tree.key().robot()).collect(Collectors.toSet());
  }

  Optional<Branch> find(Key key) {
    Optional<Branch> at = trees.stream().filter(t -> t.key().robot().equals(key.robot())).findFirst();
    for (String part : Branch.parts(key.name())) {
      at = at.flatMap(b -> b.children().stream().filter(c -> c.label().equals(part)).findFirst());
    }
    return at;
  }

  /** Asks robots; blocks. One that does not answer keeps what it said before. */
  static final class Lister {
    private final Map<String, List<Item>> names = new HashMap<>();
    private final Map<String, List<Item>> tunable = new HashMap<>();
    private final Map<String, Branch> trees = new HashMap<>();
    private Directory last = NOTHING;

    /** The same object as before where nothing changed. */
    Directory list(List<Robot> robots) {
      List<String> asked = robots.stream().map(r -> r.source().component()).toList();
      names.keySet().retainAll(asked);
      Map<String, String> failures = new HashMap<>();
      robots.forEach(robot -> ask(robot).ifPresent(why -> failures.put(robot.source().component(), why)));
      List<Branch> grown = asked.stream().filter(names::containsKey).map(trees::get).toList();
      List<Key> servers = new ArrayList<>();
      asked.forEach(r -> tunable.getOrDefault(r, List.of()).forEach(item -> servers.add(new Key(r, item.name()))));
      Directory next = new Directory(grown, List.copyOf(servers), Map.copyOf(failures), asked);
      boolean same =
          same(grown, last.trees()) && next.servers().equals(last.servers()) && failures.equals(last.failures())
              && asked.equals(last.asked());
      last = same ? last : next;
      return last;
    }

    private Optional<String> ask(Robot robot) {
      String name = robot.source().component();
      try {
        List<Item> found = robot.browser().list(Kind.PARAMETER);
        if (!found.equals(names.put(name, found))) {
          trees.put(name, Branch.tree(name, found.stream().map(Item::name).toList()));
        }
        tunable.put(name, robot.browser().list(Kind.TUNABLE));
        return Optional.empty();
      } catch (CallException e) {
        return Optional.of(e.getMessage());
      }
    }

    private static boolean same(List<Branch> one, List<Branch> other) {
      boolean same = one.size() == other.size();
      for (int i = 0; same && i < one.size(); i++) {
        same = one.get(i) == other.get(i);
      }
      return same;
    }
  }
}
