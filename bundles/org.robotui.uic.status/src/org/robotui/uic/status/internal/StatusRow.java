package org.robotui.uic.status.internal;

import java.util.List;
import org.robotui.ui.Health;
import org.robotui.ui.Role;

/** What one line shows. */
sealed interface StatusRow {
  /** What identifies it, so that it stays selected while others come and go. */
  Object key();

  /** Everything about it, for tooltip and clipboard. */
  String details();

  /** Whether it contains some words, which are in lower case. */
  default boolean says(String words) {
    return contains(details(), words);
  }

  /** Whether a text contains words in any case, without making another text. */
  static boolean contains(String text, String words) {
    int at = text.length() - words.length();
    while (at >= 0 && !text.regionMatches(true, at, words, 0, words.length())) {
      at--;
    }
    return at >= 0;
  }

  /**
   * A heading.
   *
   * @param key the words
   */
  record Head(String key) implements StatusRow {
    @Override
    public String details() {
      return key;
    }

    @Override
    public boolean says(String words) {
      return true;
    }
  }

  /** A thing with a state. */
  sealed interface Item extends StatusRow permits Said, PortRow {
    /** Its dot. */
    Health health();

    /** What it is. */
    String name();

    /** Its rate, or the word of its state. */
    String word();

    /** How old its newest value is, or empty. */
    String age();

    /** What was lost, or empty. */
    String dropped();

    /** Its newest value, or the reason of its state. */
    String value();
  }

  /**
   * A thing of which all is said already.
   *
   * @param key what identifies it
   * @param health its dot
   * @param name what it is
   * @param word the word of its state
   * @param value the reason of its state
   * @param details for the tooltip
   */
  record Said(String key, Health health, String name, String word, String value, String details) implements Item {
    @Override
    public String age() {
      return "";
    }

    @Override
    public String dropped() {
      return "";
    }
  }

  /**
   * A battery.
   *
   * @param key what identifies it
   * @param health its dot
   * @param name whose it is
   * @param charge 0 to 1, NaN where it is not measured
   * @param texts charge, voltage, current; each shorter one leaves out what matters least
   * @param details for the tooltip
   */
  record Charge(String key, Health health, String name, double charge, List<String> texts, String details)
      implements StatusRow {}

  /**
   * A sentence.
   *
   * @param key what identifies it
   * @param role its colour
   * @param details the sentence
   */
  record Note(String key, Role role, String details) implements StatusRow {}
}
