package org.robotui.core.internal.config;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;

/** Finds what a user probably meant. */
final class NearestWord {
  private NearestWord() {}

  /** The valid word nearest to what was written, where it is near enough to be a slip. */
  static Optional<String> of(String written, Collection<String> valid) {
    int limit = Math.max(1, written.length() / 3 + 1);
    return valid.stream()
        .min(Comparator.comparingInt((String word) -> distance(written, word)).thenComparing(Comparator.naturalOrder()))
        .filter(word -> distance(written, word) <= limit);
  }

  /** ": did you mean 'map'?", or the valid words where nothing is near. */
  static String hint(String written, Collection<String> valid) {
    return of(written, valid)
        .map(word -> "; did you mean '" + word + "'?")
        .orElse(valid.isEmpty() ? "" : "; valid are " + String.join(", ", valid.stream().sorted().toList()));
  }

  /** Edits to get from one word to the other: insert, delete, replace, swap neighbours. Case does not count. */
  static int distance(String left, String right) {
    String a = left.toLowerCase(Locale.ROOT);
    String b = right.toLowerCase(Locale.ROOT);
    int[][] d = new int[a.length() + 1][b.length() + 1];
    for (int i = 0; i <= a.length(); i++) {
      for (int j = 0; j <= b.length(); j++) {
        d[i][j] = i == 0 || j == 0 ? i + j : cheapest(a, b, d, i, j);
      }
    }
    return d[a.length()][b.length()];
  }

  private static int cheapest(String a, String b, int[][] d, int i, int j) {
    int replace = d[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
    int best = Math.min(replace, Math.min(d[i - 1][j], d[i][j - 1]) + 1);
    boolean swapped = i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1);
    return swapped ? Math.min(best, d[i - 2][j - 2] + 1) : best;
  }
}
