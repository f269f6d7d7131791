package org.robotui.workbench.internal.model;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * Something that the search finds and does.
 *
 * @param group where it belongs: a menu, a view, or what kind of thing it is
 * @param label what it does
 * @param keys which keys do the same, empty for none
 * @param run does it; display thread
 */
public record SearchEntry(String group, String label, String keys, Runnable run) {
  /**
   * Those that have all of some words in them: first those whose label begins with them, then those with a word that
   * does, each in their order.
   */
  public static List<SearchEntry> find(List<SearchEntry> all, String wanted) {
    String words = wanted.strip().toLowerCase(Locale.ROOT);
    return all.stream().filter(e -> e.has(words)).sorted(Comparator.comparingInt(e -> e.distance(words))).toList();
  }

  private boolean has(String words) {
    String text = (label + " " + group).toLowerCase(Locale.ROOT);
    return Arrays.stream(words.split(" +")).allMatch(text::contains);
  }

  private int distance(String words) {
    String text = label.toLowerCase(Locale.ROOT);
    return text.startsWith(words) ? 0 : text.contains(" " + words) ? 1 : 2;
  }
}
