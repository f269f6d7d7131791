package org.robotui.rfic.ros.internal.graph;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.net.call.Outcome;
import org.robotui.ros.Reception;

/** One master, as all interfaces see it that speak to it. Safe for all threads. */
final class SharedMaster {
  /** A graph, and when it was asked for. */
  private record Seen(Outcome<SharedGraph> graph, long atNanos) {}

  /** A transform that holds for good, and who said it. */
  private record Fixed(TransformStamped transform, Reception reception) {}

  private static final int MOST_FIXED = 10_000;

  private final ReentrantLock asking = new ReentrantLock();
  private final List<TransformFeed> feeds = new CopyOnWriteArrayList<>();
  private final Set<String> namespaces = ConcurrentHashMap.newKeySet();
  private final Map<String, Fixed> fixed = new ConcurrentHashMap<>();
  private final AtomicReference<TransformFeed> listener = new AtomicReference<>();
  private volatile Optional<Seen> seen = Optional.empty();

  /**
   * The graph. Where nobody asked lately the caller does, by its own node and on its own thread; who comes meanwhile
   * gets what was there before.
   *
   * @param ask asks the master
   * @param nowNanos {@link System#nanoTime()}
   * @param freshNanos how old it may be
   */
  Outcome<SharedGraph> graph(Supplier<Outcome<SharedGraph>> ask, long nowNanos, long freshNanos) {
    Optional<Outcome<SharedGraph>> fresh = notOlder(nowNanos, freshNanos);
    if (fresh.isPresent()) {
      return fresh.get();
    }
    if (!asking.tryLock()) {
      // Who asks may hang: what is too old to be true is asked for by everybody.
      return notOlder(nowNanos, 3 * freshNanos).orElseGet(ask);
    }
    try {
      Outcome<SharedGraph> answer = ask.get();
      seen = Optional.of(new Seen(answer, System.nanoTime()));
      return answer;
    } finally {
      asking.unlock();
    }
  }

  private Optional<Outcome<SharedGraph>> notOlder(long nowNanos, long nanos) {
    return seen.filter(s -> nowNanos - s.atNanos() < nanos).map(Seen::graph);
  }

  /** Whether a name is that of a robot whose interface speaks to this master, or of a namespace in the graph. */
  boolean isNamespace(String name) {
    return namespaces.contains(name)
        || seen.flatMap(s -> s.graph().toOptional()).filter(g -> g.namespaces().contains(name)).isPresent();
  }

  /** Takes one more to which what is heard is given; what was said once and holds for good it is told now. */
  void add(TransformFeed feed) {
    feeds.add(feed);
    namespaces.add(feed.namespace());
    fixed.values().forEach(f -> feed.received(new TFMessage(List.of(f.transform())), f.reception(), true));
  }

  void remove(TransformFeed feed) {
    feeds.remove(feed);
    if (listener.compareAndSet(feed, null)) {
      fixed.clear(); // who listens next is told it again
    }
  }

  /** What the one that listens hears. */
  void heard(TFMessage message, Reception reception, boolean forGood) {
    if (forGood) {
      message.transforms().stream().filter(t -> fixed.size() < MOST_FIXED || fixed.containsKey(t.childFrameId()))
          .forEach(t -> fixed.put(t.childFrameId(), new Fixed(t, reception)));
    }
    feeds.forEach(feed -> feed.received(message, reception, forGood));
  }

  /** True where this one is to listen for all from now on, as nobody does. */
  boolean listens(TransformFeed feed) {
    return listener.compareAndSet(null, feed);
  }
}
