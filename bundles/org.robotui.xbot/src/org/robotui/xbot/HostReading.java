package org.robotui.xbot;

import java.util.List;
import java.util.Map;

/**
 * What a process of plugins says of itself. It may say anything: it is the process that can break.
 *
 * @param threads its threads, by index
 * @param plugins what is known of each of its plugins, by index on the board
 * @param damage what of its memory a plugin has overwritten, as words such as "its head is overwritten": then nothing
 * else is told; empty where nothing is seen to be
 */
public record HostReading(List<Timing> threads, Map<Integer, Plugin> plugins, String damage) {
  /**
   * One plugin.
   *
   * @param cycles how often it was called
   * @param lastNanos how long the last call took
   * @param busy how long calls took
   */
  public record Plugin(long cycles, long lastNanos, Timing.Buckets busy) {}

  /**
   * Copies both.
   *
   * @param threads by index
   * @param plugins by index on the board
   * @param damage what is overwritten
   */
  public HostReading {
    threads = List.copyOf(threads);
    plugins = Map.copyOf(plugins);
  }

  /**
   * One that is sound.
   *
   * @param threads by index
   * @param plugins by index on the board
   */
  public HostReading(List<Timing> threads, Map<Integer, Plugin> plugins) {
    this(threads, plugins, "");
  }
}
