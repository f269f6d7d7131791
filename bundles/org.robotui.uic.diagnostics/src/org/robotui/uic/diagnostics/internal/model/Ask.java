package org.robotui.uic.diagnostics.internal.model;

import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * What the user wants to see.
 *
 * @param source the source to show; empty to have it chosen, {@link #ALL_SOURCES} for all
 * @param opened groups that the user opened
 * @param closed groups that the user closed
 * @param problems whether only what is not as it should be is shown
 * @param search words that must occur
 * @param selected the line whose details are shown
 * @param slot the moment looked at; none for now
 */
public record Ask(String source, Set<String> opened, Set<String> closed, boolean problems, String search,
    Optional<String> selected,
    Optional<Long> slot) {
  /** Shows each source below its own name. */
  public static final String ALL_SOURCES = "*";

  /** What is shown at the beginning. */
  public static final Ask DEFAULT = new Ask("", Set.of(), Set.of(), false, "", Optional.empty(), Optional.empty());

  /** Copies the sets. */
  public Ask {
    opened = Set.copyOf(opened);
    closed = Set.copyOf(closed);
  }

  /** Of another source. */
  public Ask source(String next) {
    return new Ask(next, opened, closed, problems, search, selected, slot);
  }

  /** With a group open or closed. */
  public Ask open(String key, boolean open) {
    return new Ask(source, with(opened, key, open), with(closed, key, !open), problems, search, selected, slot);
  }

  /** With all lines, or with problems only. */
  public Ask problems(boolean only) {
    return new Ask(source, opened, closed, only, search, selected, slot);
  }

  /** With words to be searched. */
  public Ask search(String words) {
    return new Ask(source, opened, closed, problems, words, selected, slot);
  }

  /** With the details of a line. */
  public Ask select(Optional<String> key) {
    return new Ask(source, opened, closed, problems, search, key, slot);
  }

  /** At another moment. */
  public Ask at(Optional<Long> moment) {
    return new Ask(source, opened, closed, problems, search, selected, moment);
  }

  /** Whether a group is open: as the user left it, else where it is at the top. */
  public boolean isOpen(String key, int depth) {
    return opened.contains(key) || depth == 0 && !closed.contains(key);
  }

  private static Set<String> with(Set<String> set, String key, boolean in) {
    Set<String> next = new TreeSet<>(set);
    if (in) {
      next.add(key);
    } else {
      next.remove(key);
    }
    return next;
  }
}
