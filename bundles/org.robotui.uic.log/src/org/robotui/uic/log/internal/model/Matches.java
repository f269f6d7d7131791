package org.robotui.uic.log.internal.model;

import java.util.List;
import java.util.function.LongSupplier;

/**
 * The lines that a filter leaves of a store. It looks at each entry once, as far as its time allows: a changed filter
 * over many entries, or a slow expression, takes several ticks and never holds one up. One thread.
 */
final class Matches {
  private final Chunks<LogLine> lines = new Chunks<>();
  private final LongSupplier nanos;
  private LogFilter filter = LogFilter.ALL;
  private boolean searching;
  private long next;
  private long looked;

  Matches(LongSupplier nanos) {
    this.nanos = nanos;
  }

  /** Follows the store up to an entry, and the filter, for at most some time. */
  void follow(Store store, long endId, LogFilter wanted, long budgetNanos) {
    forget(store.firstId());
    if (!wanted.equals(filter) || searching != wanted.search().active()) {
      filter = wanted;
      searching = wanted.search().active();
      lines.clear();
      next = store.firstId();
    }
    next = Math.max(next, store.firstId());
    long end = nanos.getAsLong() + budgetNanos;
    while (next < endId && nanos.getAsLong() <= end) {
      look(store.get(next++));
    }
  }

  /** The id of the first entry that it has not looked at yet. */
  long next() {
    return next;
  }

  /** How many entries it has looked at since the beginning. */
  long looked() {
    return looked;
  }

  List<LogLine> lines() {
    return lines.picture();
  }

  private void look(Entry entry) {
    looked++;
    if (!filter.accepts(entry)) {
      return;
    }
    int size = lines.size();
    if (filter.collapse() && size > 0 && lines.get(size - 1).last().says(entry)) {
      lines.replaceLast(lines.get(size - 1).and(entry));
    } else {
      lines.add(LogLine.of(entry));
    }
  }

  private void forget(long firstId) {
    while (lines.size() > 0 && lines.get(0).last().id() < firstId) {
      lines.removeFirst();
    }
  }
}
