package org.robotui.uic.diagnostics.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What the view shows; immutable.
 *
 * @param ask what was asked for
 * @param rows the lines of the tree, as far as they are open
 * @param counts how many parts are at each level, whatever is filtered
 * @param overall how the worst of all was
 * @param level the worst of all, at the moment looked at
 * @param detail of the selected line
 * @param sources those that have reported, for choosing
 * @param source the one that is shown, or none where all are
 * @param parts how many parts are known, of the sources shown
 * @param refused reports of parts beyond the bound
 * @param slotSeconds how long a slot of the strips is
 * @param newestReport monotonic time of the newest report, seconds
 * @param now monotonic time of this picture, nanoseconds
 */
public record Shown(Ask ask, List<DiagnosticsRow> rows, Map<Level, Integer> counts, Strip overall, Level level,
    Optional<DiagnosticsDetail> detail,
    List<String> sources, Optional<String> source, int parts, long refused, double slotSeconds, double newestReport,
    long now) {
  /** How long ago a slot ended, in seconds; negative where it is still running. */
  public double secondsAgo(long slot) {
    return now * 1e-9 - (slot + 1) * slotSeconds;
  }

  /** The place of a line, or a negative number. */
  public int indexOf(String key) {
    for (int i = 0; i < rows.size(); i++) {
      if (rows.get(i).key().equals(key)) {
        return i;
      }
    }
    return -1;
  }
}
