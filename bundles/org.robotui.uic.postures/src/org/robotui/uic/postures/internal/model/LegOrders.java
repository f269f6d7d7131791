package org.robotui.uic.postures.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.robotui.api.input.Numerals;

/** The words by which the plugin that follows trajectories is told the way to one posture. */
final class LegOrders {
  /** A plugin hears 496 bytes at once; names of joints may take several each. */
  private static final int LONGEST = 320;
  private static final String BETWEEN = ";";

  private final String tag;
  private final List<String> orders = new ArrayList<>();
  private final StringBuilder order = new StringBuilder();

  private LegOrders(long tag) {
    this.tag = "@" + tag + " ";
  }

  /**
   * In the order in which they are to be said.
   *
   * @param tag tells them from those of others; above 0
   * @param joints where they are to be
   * @param seconds how long that takes, at least
   * @param speed share of the greatest speed of joints
   */
  static List<String> of(long tag, Map<String, Double> joints, double seconds, double speed) {
    LegOrders made = new LegOrders(tag);
    made.say("begin");
    made.list("joints", List.copyOf(joints.keySet()));
    made.say("point " + Numerals.text(seconds));
    made.list("positions", joints.values().stream().map(Numerals::text).toList());
    made.say("velocity " + Numerals.text(speed));
    made.say("run");
    made.orders.add(made.order.toString());
    return List.copyOf(made.orders);
  }

  /** Again with the same verb where not all words fit. */
  private void list(String verb, List<String> words) {
    StringBuilder phrase = new StringBuilder(verb);
    for (String word : words) {
      if (phrase.length() + word.length() > LONGEST) {
        say(phrase.toString());
        phrase.setLength(0);
        phrase.append(verb);
      }
      phrase.append(' ').append(word);
    }
    say(phrase.toString());
  }

  private void say(String phrase) {
    if (!order.isEmpty() && order.length() + phrase.length() > LONGEST) {
      orders.add(order.toString());
      order.setLength(0);
    }
    order.append(order.isEmpty() ? tag : BETWEEN).append(phrase);
  }
}
