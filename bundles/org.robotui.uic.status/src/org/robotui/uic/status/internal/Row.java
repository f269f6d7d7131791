package org.robotui.uic.status.internal;

import org.robotui.ui.Health;
import org.robotui.ui.Role;

/** What one line shows. */
sealed interface Row {
  /** What identifies it, so that it stays selected while others come and go. */
  String key();

  /** Everything about it, for tooltip and clipboard. */
  String details();

  /**
   * A heading.
   *
   * @param key the words
   */
  record Head(String key) implements Row {
    @Override
    public String details() {
      return key;
    }
  }

  /**
   * A thing with a state.
   *
   * @param key what identifies it
   * @param health its dot
   * @param name what it is
   * @param word its rate, or the word of its state
   * @param age how old its newest value is, or empty
   * @param dropped what was lost, or empty
   * @param value its newest value, or the reason of its state
   * @param details for the tooltip
   */
  record Item(String key, Health health, String name, String word, String age, String dropped, String value, String details)
      implements Row {}

  /**
   * A battery.
   *
   * @param key what identifies it
   * @param health its dot
   * @param name whose it is
   * @param charge 0 to 1, NaN where it is not measured
   * @param text charge, voltage, current
   * @param details for the tooltip
   */
  record Charge(String key, Health health, String name, double charge, String text, String details) implements Row {}

  /**
   * A sentence.
   *
   * @param key what identifies it
   * @param role its colour
   * @param details the sentence
   */
  record Note(String key, Role role, String details) implements Row {}
}
