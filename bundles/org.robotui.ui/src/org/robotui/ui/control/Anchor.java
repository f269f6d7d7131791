package org.robotui.ui.control;

import java.util.List;
import java.util.function.Function;

/** Finds where the row went that was the first seen, when rows went before it. Pure. */
final class Anchor {
  /** More than this at once is a new list, in which nothing needs to stay in place. */
  private static final int FARTHEST = 4096;

  private Anchor() {}

  static <R> int find(List<R> before, List<R> after, int index, Function<R, Object> key) {
    if (index >= before.size() || after.isEmpty()) {
      return -1;
    }
    Object wanted = key.apply(before.get(index));
    int start = Math.min(index, after.size() - 1);
    for (int i = start; i >= 0 && i > start - FARTHEST; i--) {
      if (key.apply(after.get(i)).equals(wanted)) {
        return i;
      }
    }
    return -1;
  }
}
