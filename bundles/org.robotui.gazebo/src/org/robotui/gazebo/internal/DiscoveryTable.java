package org.robotui.gazebo.internal;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Ends;

/** What other processes have, and when each was heard last. What it keeps is bounded. Used by one thread. */
final class DiscoveryTable {
  private static final int MOST_PROCESSES = 1000;
  private static final int MOST = 20_000;

  private final Map<String, Long> heard = new HashMap<>();
  private final Map<Key, Announcement> announced = new LinkedHashMap<>();
  private final Map<Key, Announcement> subscriptions = new LinkedHashMap<>();

  private record Key(String process, String node, String topic, String control) {
    static Key of(Announcement said) {
      return new Key(said.process(), said.node(), said.topic(), control(said));
    }

    static String control(Announcement said) {
      return said.ends() instanceof Ends.Messages messages ? messages.control() : "";
    }
  }

  /**
   * What ended with a process.
   *
   * @param announced by it
   * @param subscriptions of its nodes
   */
  record Gone(List<Announcement> announced, List<Announcement> subscriptions) {}

  /** Whether there is room for what another process says. */
  boolean hears(String process, long now) {
    if (!heard.containsKey(process) && heard.size() >= MOST_PROCESSES) {
      return false;
    }
    heard.put(process, now);
    return true;
  }

  boolean knows(String process) {
    return heard.containsKey(process);
  }

  List<String> processes() {
    return List.copyOf(heard.keySet());
  }

  List<String> silent(long now, long nanos) {
    return heard.entrySet().stream().filter(each -> now - each.getValue() > nanos).map(Map.Entry::getKey).toList();
  }

  /** Takes note of it; answers what it takes the place of, if that is something else. */
  List<Announcement> announce(Announcement said) {
    return put(announced, said);
  }

  List<Announcement> subscribe(Announcement said) {
    return put(subscriptions, said);
  }

  private static List<Announcement> put(Map<Key, Announcement> all, Announcement said) {
    if (all.size() >= MOST && !all.containsKey(Key.of(said))) {
      return List.of();
    }
    Announcement before = all.put(Key.of(said), said);
    return before == null || before.equals(said) ? List.of() : List.of(before);
  }

  List<Announcement> withdraw(Announcement said) {
    return taken(announced, each -> isOfNode(each, said));
  }

  /** One that names no publisher ends the subscriptions to all of them. */
  List<Announcement> unsubscribe(Announcement said) {
    String control = Key.control(said);
    return taken(subscriptions,
        each -> isOfNode(each, said) && (control.isEmpty() || control.equals(Key.control(each))));
  }

  private static boolean isOfNode(Announcement each, Announcement said) {
    return each.process().equals(said.process()) && each.node().equals(said.node())
        && each.topic().equals(said.topic());
  }

  Gone remove(String process) {
    heard.remove(process);
    Predicate<Announcement> its = each -> each.process().equals(process);
    return new Gone(taken(announced, its), taken(subscriptions, its));
  }

  private static List<Announcement> taken(Map<Key, Announcement> all, Predicate<Announcement> which) {
    List<Announcement> of = all.values().stream().filter(which).toList();
    all.values().removeAll(of);
    return of;
  }
}
