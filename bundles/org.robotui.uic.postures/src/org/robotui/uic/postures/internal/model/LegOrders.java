package org.robotui.uic.postures.internal.model;

import java.util.List;
import java.util.Map;
import org.robotui.api.input.Numerals;
import org.robotui.data.control.PluginPhrases;

/** The words by which the plugin that follows trajectories is told the way to one posture. */
final class LegOrders {
  private LegOrders() {}

  /**
   * In the order in which they are to be said.
   *
   * @param tag tells them from those of others; above 0
   * @param joints where they are to be
   * @param seconds how long that takes, at least
   * @param speed share of the greatest speed of joints
   */
  static List<String> of(long tag, Map<String, Double> joints, double seconds, double speed) {
    return new PluginPhrases(tag).say("begin").list("joints", List.copyOf(joints.keySet()))
        .say("point " + Numerals.text(seconds))
        .list("positions", joints.values().stream().map(Numerals::text).toList())
        .say("velocity " + Numerals.text(speed)).say("run").orders();
  }
}
