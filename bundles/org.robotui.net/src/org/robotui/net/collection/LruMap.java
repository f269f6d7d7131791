package org.robotui.net.collection;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A map of so many entries at most: what was neither read nor written for the longest time goes first. Since reading
 * changes the order, several threads need a lock even where they only read.
 *
 * @param <K> the keys
 * @param <V> the values
 */
public final class LruMap<K, V> extends LinkedHashMap<K, V> {
  private static final long serialVersionUID = 1L;

  private final int most;

  /**
   * An empty map, which takes memory for what it holds only.
   *
   * @param most how many entries it holds; at least one
   */
  public LruMap(int most) {
    super(16, 0.75f, true);
    if (most < 1) {
      throw new IllegalArgumentException("a map of at most " + most + " entries can hold nothing");
    }
    this.most = most;
  }

  @Override
  protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
    return size() > most;
  }
}
