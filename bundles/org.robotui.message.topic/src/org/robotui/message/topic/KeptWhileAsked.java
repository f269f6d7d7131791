package org.robotui.message.topic;

import java.time.Duration;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Ends of ours by which parts of a robot are asked: kept from the first question until nobody has asked for a while.
 * Safe for all threads.
 *
 * @param <K> names a part
 * @param <V> our end
 */
public final class KeptWhileAsked<K, V> implements AutoCloseable {
  private static final Duration IDLE = Duration.ofSeconds(20);

  private final Function<K, V> opener;
  private final Consumer<V> closer;
  private final Map<K, Kept<V>> ends = new HashMap<>();

  /** An end, and when it was asked for last. */
  private record Kept<V>(V end, long atNanos) {}

  /**
   * Keeps nothing yet.
   *
   * @param opener opens an end; must not wait for the robot
   * @param closer closes it
   */
  public KeptWhileAsked(Function<K, V> opener, Consumer<V> closer) {
    this.opener = opener;
    this.closer = closer;
  }

  /**
   * The end for a part.
   *
   * @param part which one
   * @return one that stays open for a while
   */
  public synchronized V of(K part) {
    Kept<V> kept = ends.get(part);
    V end = kept == null ? opener.apply(part) : kept.end();
    ends.put(part, new Kept<>(end, System.nanoTime()));
    return end;
  }

  /** Closes those for which nobody has asked for a while. To be called regularly. */
  public synchronized void tick() {
    for (Iterator<Kept<V>> all = ends.values().iterator(); all.hasNext();) {
      Kept<V> kept = all.next();
      if (System.nanoTime() - kept.atNanos() > IDLE.toNanos()) {
        all.remove();
        closer.accept(kept.end());
      }
    }
  }

  /** Closes all. */
  @Override
  public synchronized void close() {
    ends.values().forEach(kept -> closer.accept(kept.end()));
    ends.clear();
  }
}
