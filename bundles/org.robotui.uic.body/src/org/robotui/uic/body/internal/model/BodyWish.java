package org.robotui.uic.body.internal.model;

import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * What the user wants to see.
 *
 * @param turned lines that are open where they usually are closed, and the other way round
 * @param search words that a line has to have
 * @param selected whose history is shown
 */
public record BodyWish(Set<String> turned, String search, Optional<String> selected) {
  /** Parts are open, messages closed. */
  public static final BodyWish FIRST = new BodyWish(Set.of(), "", Optional.empty());

  private static final int MOST = 2000;

  /** Copies the set. */
  public BodyWish {
    turned = Set.copyOf(turned);
  }

  /** With a line that is opened or closed. */
  public BodyWish turn(String key) {
    Set<String> next = new TreeSet<>(turned);
    if (!next.remove(key) && next.size() < MOST) {
      next.add(key);
    }
    return new BodyWish(next, search, selected);
  }

  public BodyWish search(String words) {
    return new BodyWish(turned, words, selected);
  }

  public BodyWish select(Optional<String> key) {
    return new BodyWish(turned, search, key);
  }
}
