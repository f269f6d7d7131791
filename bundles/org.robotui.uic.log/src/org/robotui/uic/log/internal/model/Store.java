package org.robotui.uic.log.internal.model;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robotui.data.status.Severity;

/** The newest entries, bounded in number and in memory. One thread. */
final class Store {
  private static final int MOST_ORIGINS = 1000;

  private final Chunks<Entry> entries = new Chunks<>();
  private final Map<Severity, Integer> severities = new EnumMap<>(Severity.class);
  private final Map<String, Integer> origins = new TreeMap<>();
  private long firstId;
  private long bytes;

  void add(Entry entry, int most, long mostBytes) {
    if (entries.size() == 0) {
      firstId = entry.id();
    }
    entries.add(entry);
    bytes += entry.bytes();
    severities.merge(entry.severity(), 1, Integer::sum);
    origins.merge(entry.origin(), 1, Integer::sum);
    while (entries.size() > most || bytes > mostBytes && entries.size() > 1) {
      forgetFirst();
    }
  }

  /** The id of the oldest entry that is kept. */
  long firstId() {
    return firstId;
  }

  /** The id after that of the newest entry. */
  long endId() {
    return firstId + entries.size();
  }

  Entry get(long id) {
    return entries.get((int) (id - firstId));
  }

  int size() {
    return entries.size();
  }

  long bytes() {
    return bytes;
  }

  int count(Severity severity) {
    return severities.getOrDefault(severity, 0);
  }

  /** Who said something that is kept, by name; of very many the first. */
  List<OriginCount> origins() {
    return origins.entrySet().stream().limit(MOST_ORIGINS).map(e -> new OriginCount(e.getKey(), e.getValue())).toList();
  }

  void clear() {
    firstId = endId();
    entries.clear();
    severities.clear();
    origins.clear();
    bytes = 0;
  }

  private void forgetFirst() {
    Entry gone = entries.removeFirst();
    firstId++;
    bytes -= gone.bytes();
    severities.merge(gone.severity(), -1, Integer::sum);
    origins.computeIfPresent(gone.origin(), (name, count) -> count == 1 ? null : count - 1);
  }
}
