package org.robotui.ui.control;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/** Which rows are selected, by key, whatever happens to their places. Pure. */
final class RowMarks<R> {
  private final Function<R, Object> keys;
  private final Set<Object> marked = new LinkedHashSet<>();
  private List<R> rows = List.of();
  private Optional<Object> lead = Optional.empty();
  private Optional<Object> anchor = Optional.empty();
  private int near;

  RowMarks(Function<R, Object> keys) {
    this.keys = keys;
  }

  void rows(List<R> next) {
    rows = next;
  }

  boolean has(R row) {
    return !marked.isEmpty() && marked.contains(keys.apply(row));
  }

  boolean leads(R row) {
    return lead.isPresent() && lead.get().equals(keys.apply(row));
  }

  /** Where the row is that keys move from, or -1. */
  int leadIndex() {
    near = lead.map(this::find).orElse(-1);
    return near;
  }

  /** Selects one row and no other. */
  void only(int index) {
    marked.clear();
    lead(index);
    marked.add(lead.orElseThrow());
    anchor = lead;
  }

  /** Selects or leaves a row beside the others. */
  void toggle(int index) {
    lead(index);
    Object key = lead.orElseThrow();
    if (!marked.remove(key)) {
      marked.add(key);
    }
    anchor = lead;
  }

  /** Selects from where the last selection began to a row. */
  void extend(int index) {
    int from = anchor.map(this::find).filter(i -> i >= 0).orElse(index);
    anchor = Optional.of(keys.apply(rows.get(from)));
    marked.clear();
    rows.subList(Math.min(from, index), Math.max(from, index) + 1).forEach(row -> marked.add(keys.apply(row)));
    lead(index);
  }

  void all() {
    rows.forEach(row -> marked.add(keys.apply(row)));
  }

  void key(Object key) {
    marked.clear();
    marked.add(key);
    lead = Optional.of(key);
    anchor = lead;
  }

  /** Selects these keys and no others; keys move on from where they were. */
  void keys(Collection<?> selected) {
    marked.clear();
    marked.addAll(selected);
    lead = lead.filter(marked::contains).or(() -> marked.stream().findFirst());
    anchor = lead;
  }

  boolean clear() {
    boolean any = !marked.isEmpty();
    marked.clear();
    lead = Optional.empty();
    anchor = lead;
    return any;
  }

  /** The selected rows that there are, in the order shown. */
  List<R> selected() {
    if (marked.size() > 1) {
      return rows.stream().filter(this::has).toList();
    }
    return marked.stream().map(this::find).filter(i -> i >= 0).map(rows::get).toList();
  }

  private void lead(int index) {
    lead = Optional.of(keys.apply(rows.get(index)));
    near = index;
  }

  /** Most rows stay where they were, so one look there comes first. */
  private int find(Object key) {
    if (near >= 0 && near < rows.size() && keys.apply(rows.get(near)).equals(key)) {
      return near;
    }
    for (int i = 0; i < rows.size(); i++) {
      if (keys.apply(rows.get(i)).equals(key)) {
        return i;
      }
    }
    return -1;
  }
}
