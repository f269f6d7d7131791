package org.robotui.data.control;

import java.util.ArrayList;
import java.util.List;

/**
 * Phrases for a plugin of a control, as few orders as they fit into. A plugin hears a short text at once, and takes
 * several phrases in it with semicolons between them. For one thread.
 */
public final class PluginPhrases {
  /** A plugin hears 496 bytes at once; names of joints may take several each. */
  private static final int LONGEST = 320;
  private static final String BETWEEN = ";";

  private final String tag;
  private final List<String> orders = new ArrayList<>();
  private final StringBuilder order = new StringBuilder();

  /**
   * Says nothing yet.
   *
   * @param tag tells the orders from those of other clients; above 0
   */
  public PluginPhrases(long tag) {
    this.tag = "@" + tag + " ";
  }

  /**
   * Says a phrase.
   *
   * @param phrase a verb and what belongs to it
   * @return this
   */
  public PluginPhrases say(String phrase) {
    if (!order.isEmpty() && order.length() + phrase.length() > LONGEST) {
      orders.add(order.toString());
      order.setLength(0);
    }
    order.append(order.isEmpty() ? tag : BETWEEN).append(phrase);
    return this;
  }

  /**
   * Says a verb with words, again with the same verb where not all of them fit.
   *
   * @param verb the verb
   * @param words what belongs to it
   * @return this
   */
  public PluginPhrases list(String verb, List<String> words) {
    StringBuilder phrase = new StringBuilder(verb);
    for (String word : words) {
      if (phrase.length() + word.length() > LONGEST) {
        say(phrase.toString());
        phrase.setLength(0);
        phrase.append(verb);
      }
      phrase.append(' ').append(word);
    }
    return say(phrase.toString());
  }

  /**
   * All that was said.
   *
   * @return in the order in which they are to be told
   */
  public List<String> orders() {
    List<String> all = new ArrayList<>(orders);
    if (!order.isEmpty()) {
      all.add(order.toString());
    }
    return List.copyOf(all);
  }
}
