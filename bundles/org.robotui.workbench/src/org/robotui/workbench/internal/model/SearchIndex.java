package org.robotui.workbench.internal.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * What the search finds, prepared once for all letters that are typed: texts in lower case, where words begin in them,
 * and which letters they have, so that most entries are passed over without a look at their text. Immutable.
 */
public final class SearchIndex {
  private static final int ALL_LETTERS = 64;
  /** A gap costs more than a letter, so that letters side by side come first. */
  private static final int GAP = 3;

  private final List<Prepared> all;

  /** Prepares entries. */
  public SearchIndex(List<SearchEntry> entries) {
    all = entries.stream().map(Prepared::of).toList();
  }

  /**
   * The entries that fit, the nearest first. Those whose label begins with the words; those with a word that does;
   * those that have the words anywhere in label or group; those that have at least the letters, in this order: of
   * {@code sar}, the first letters of <i>Stop All Robots</i> before letters within words.
   *
   * @param wanted as it was typed; all entries where it is blank
   */
  public List<SearchEntry> find(String wanted) {
    String words = wanted.strip().toLowerCase(Locale.ROOT);
    if (words.isEmpty()) {
      return all.stream().map(Prepared::entry).toList();
    }
    Query query = new Query(words, words.split(" +"), words.replace(" ", ""), letters(words));
    List<Found> found = new ArrayList<>();
    for (Prepared each : all) {
      int distance = (query.letters & ~each.letters) == 0 ? each.distance(query) : Integer.MAX_VALUE;
      if (distance < Integer.MAX_VALUE) {
        found.add(new Found(each.entry, distance));
      }
    }
    found.sort(Comparator.comparingInt(Found::distance));
    return found.stream().map(Found::entry).toList();
  }

  /** A bit for each letter of a text; some letters share one. Blanks have none. */
  private static long letters(String text) {
    return text.chars().filter(c -> c != ' ').mapToLong(c -> 1L << c % ALL_LETTERS).reduce(0, (a, b) -> a | b);
  }

  private record Query(String words, String[] each, String joined, long letters) {}

  private record Found(SearchEntry entry, int distance) {}

  private record Prepared(SearchEntry entry, String label, String text, boolean[] starts, long letters) {
    private static final int WORD = 1;
    private static final int WITHIN = 2;
    private static final int ANYWHERE = 3;
    private static final int LETTERS = 4;

    static Prepared of(SearchEntry entry) {
      String label = entry.label().toLowerCase(Locale.ROOT);
      String text = label + " " + entry.group().toLowerCase(Locale.ROOT);
      // Lower case may have another length than what was written; humps are looked for only where it has not.
      String shape = label.length() == entry.label().length() ? entry.label() : label;
      boolean[] starts = new boolean[label.length()];
      for (int i = 0; i < starts.length; i++) {
        char c = shape.charAt(i);
        boolean first = i == 0 || !Character.isLetterOrDigit(shape.charAt(i - 1));
        boolean hump = i > 0 && Character.isUpperCase(c) && Character.isLowerCase(shape.charAt(i - 1));
        starts[i] = Character.isLetterOrDigit(c) && (first || hump);
      }
      return new Prepared(entry, label, text, starts, SearchIndex.letters(text));
    }

    /** In ranks far apart, so that what counts within a rank never reaches the next. */
    int distance(Query query) {
      int at = label.indexOf(query.words);
      if (at == 0) {
        return 0;
      }
      int rank = at > 0 ? begins(query.words, at) ? WORD : WITHIN
          : Arrays.stream(query.each).allMatch(text::contains) ? ANYWHERE : LETTERS;
      int spread = rank == LETTERS ? spread(query.joined) : 0;
      return spread < 0 ? Integer.MAX_VALUE : (rank << 16) + spread;
    }

    private boolean begins(String words, int first) {
      for (int at = first; at >= 0; at = label.indexOf(words, at + 1)) {
        if (starts[at] || !Character.isLetterOrDigit(words.charAt(0))) {
          return true;
        }
      }
      return false;
    }

    /** How far apart the letters lie that were typed; -1 where they are not there, or not to be recognised. */
    private int spread(String typed) {
      if (typed.length() < 2) {
        return -1;
      }
      int initials = walk(typed, true);
      int spread = initials >= 0 ? initials : walk(typed, false);
      return spread > typed.length() * GAP * 2 ? -1 : spread;
    }

    /** Letters side by side cost nothing; otherwise the next one may have to begin a word. */
    private int walk(String typed, boolean jumpsToStarts) {
      int cost = 0;
      int at = -1;
      for (int i = 0; i < typed.length(); i++) {
        char c = typed.charAt(i);
        int next = at + 1;
        boolean beside = at >= 0 && next < label.length() && label.charAt(next) == c;
        while (!beside && next < label.length() && (label.charAt(next) != c || jumpsToStarts && !starts[next])) {
          next++;
        }
        if (next >= label.length()) {
          return -1;
        }
        cost += beside || i == 0 ? 0 : jumpsToStarts ? 1 : GAP + next - at;
        at = next;
      }
      return cost;
    }
  }
}
