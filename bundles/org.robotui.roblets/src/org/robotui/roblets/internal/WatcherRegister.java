package org.robotui.roblets.internal;

import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import org.robotui.roblets.tree.BodyElement;

/** Who looks at a brain, and at which roblets. Who does not say so again is forgotten. Safe for all threads. */
public final class WatcherRegister {
  private static final int MOST = 64;
  private static final long LASTS_NANOS = Duration.ofSeconds(3).toNanos();
  private static final String ALL = "*";

  private final Map<InetSocketAddress, Watching> watchers = new ConcurrentHashMap<>();

  private record Watching(String name, Set<String> wanted, long until) {}

  public boolean watch(String name, BodyElement watch, InetSocketAddress from, long nowNanos) {
    if (watchers.size() >= MOST && !watchers.containsKey(from)) {
      return false;
    }
    Set<String> wanted = watch.children().stream().filter(c -> c.name().equals("want"))
        .flatMap(c -> c.attribute("roblet").stream()).collect(Collectors.toSet());
    watchers.put(from, new Watching(name, wanted, nowNanos + LASTS_NANOS));
    return true;
  }

  public void leave(InetSocketAddress from) {
    watchers.remove(from);
  }

  public void expire(long nowNanos) {
    for (Iterator<Watching> each = watchers.values().iterator(); each.hasNext();) {
      if (nowNanos - each.next().until() > 0) {
        each.remove();
      }
    }
  }

  public List<InetSocketAddress> all() {
    return List.copyOf(watchers.keySet());
  }

  public List<InetSocketAddress> wanting(String roblet) {
    return watchers.entrySet().stream()
        .filter(w -> w.getValue().wanted().contains(roblet) || w.getValue().wanted().contains(ALL))
        .map(Map.Entry::getKey).toList();
  }

  public boolean knows(InetSocketAddress from) {
    return watchers.containsKey(from);
  }

  public String name(InetSocketAddress from) {
    Watching watching = watchers.get(from);
    return watching == null ? "" : watching.name();
  }

  public Set<String> names() {
    return watchers.values().stream().map(Watching::name).collect(Collectors.toCollection(TreeSet::new));
  }
}
