package org.robotui.rfic.ros.internal.graph;

import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.robotui.message.topic.SharedTransforms;
import org.robotui.net.call.Outcome;

/** One master, as all interfaces see it that speak to it. Safe for all threads. */
final class SharedMaster {
  /** A graph, and when it was asked for. */
  private record Seen(Outcome<SharedGraph> graph, long atNanos) {}

  private final ReentrantLock asking = new ReentrantLock();
  private final SharedTransforms transforms = new SharedTransforms(this::isNamespace);
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

  /** Whether a name is that of a namespace in the graph. */
  private boolean isNamespace(String name) {
    return seen.flatMap(s -> s.graph().toOptional()).filter(g -> g.namespaces().contains(name)).isPresent();
  }

  /** The transforms that interfaces hear who speak to this master. */
  SharedTransforms transforms() {
    return transforms;
  }
}
