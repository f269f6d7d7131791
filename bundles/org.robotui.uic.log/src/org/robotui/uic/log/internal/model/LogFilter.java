package org.robotui.uic.log.internal.model;

import java.util.EnumSet;
import java.util.Set;
import java.util.TreeSet;
import org.robotui.data.status.Severity;

/**
 * Which entries are shown.
 *
 * @param levels those shown
 * @param only the nodes shown; empty for all
 * @param hidden the nodes not shown, where all are
 * @param search what they must contain
 * @param collapse whether those alike in a row are one line
 */
public record LogFilter(Set<Severity> levels, Set<String> only, Set<String> hidden, Search search, boolean collapse) {
  /** Shows all. */
  public static final LogFilter ALL =
      new LogFilter(EnumSet.allOf(Severity.class), Set.of(), Set.of(), Search.ALL, false);

  /** Copies the sets. */
  public LogFilter {
    levels = Set.copyOf(levels);
    only = Set.copyOf(only);
    hidden = Set.copyOf(hidden);
  }

  /** Whether an entry is shown. */
  public boolean accepts(Entry entry) {
    return levels.contains(entry.severity()) && shows(entry.origin()) && search.accepts(entry);
  }

  /** Whether a node is shown. */
  public boolean shows(String origin) {
    return only.isEmpty() ? !hidden.contains(origin) : only.contains(origin);
  }

  /** With one level shown or not. */
  public LogFilter level(Severity severity, boolean shown) {
    Set<Severity> next = EnumSet.noneOf(Severity.class);
    next.addAll(levels);
    changed(next, severity, shown);
    return new LogFilter(next, only, hidden, search, collapse);
  }

  /** With one node alone. */
  public LogFilter onlyOrigin(String origin) {
    return new LogFilter(levels, Set.of(origin), hidden, search, collapse);
  }

  /** With one node shown or not; the last of the only ones cannot be taken away but by showing all. */
  public LogFilter origin(String origin, boolean shown) {
    if (only.isEmpty()) {
      Set<String> next = new TreeSet<>(hidden);
      changed(next, origin, !shown);
      return new LogFilter(levels, only, next, search, collapse);
    }
    Set<String> next = new TreeSet<>(only);
    changed(next, origin, shown);
    return new LogFilter(levels, next.isEmpty() ? only : next, hidden, search, collapse);
  }

  /** With all nodes. */
  public LogFilter allOrigins() {
    return new LogFilter(levels, Set.of(), Set.of(), search, collapse);
  }

  /** With another search. */
  public LogFilter search(Search next) {
    return new LogFilter(levels, only, hidden, next, collapse);
  }

  /** With those alike in one line, or not. */
  public LogFilter collapse(boolean next) {
    return new LogFilter(levels, only, hidden, search, next);
  }

  /** Without any filter; what is alike stays as it is. */
  public LogFilter cleared() {
    return new LogFilter(ALL.levels, Set.of(), Set.of(), Search.of("", search.expression()), collapse);
  }

  /** What leaves entries out, in words, or empty. */
  public String words() {
    StringBuilder words = new StringBuilder();
    if (levels.size() < Severity.values().length) {
      words.append("level");
    }
    if (!only.isEmpty() || !hidden.isEmpty()) {
      words.append(words.isEmpty() ? "" : ", ").append("node");
    }
    if (search.active()) {
      words.append(words.isEmpty() ? "" : ", ").append("search");
    }
    return words.toString();
  }

  private static <T> void changed(Set<T> set, T element, boolean in) {
    if (in) {
      set.add(element);
    } else {
      set.remove(element);
    }
  }
}
