package org.robotui.uic.diagnostics.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.SourceId;

/**
 * Which sources are shown. Robots often report twice: each part for itself, and somebody who sorts the reports of all.
 * Where exactly one source is such, and alive, it is shown alone; as soon as it is silent, all are, since those who
 * report to it may still.
 */
final class SourceChoice {
  private SourceChoice() {}

  /** The one source to show, or none where all are. */
  static Optional<SourceId> choose(String asked, Map<SourceId, Forest.Tree> trees, long now, long staleNanos) {
    if (trees.size() == 1) {
      return trees.keySet().stream().findFirst();
    }
    if (!asked.isEmpty()) {
      return trees.keySet().stream().filter(source -> source.toString().equals(asked)).findFirst();
    }
    List<SourceId> sorting = trees.entrySet().stream()
        .filter(e -> e.getValue().sorted() && e.getValue().alive(now, staleNanos)).map(Map.Entry::getKey).toList();
    return sorting.size() == 1 ? Optional.of(sorting.getFirst()) : Optional.empty();
  }
}
