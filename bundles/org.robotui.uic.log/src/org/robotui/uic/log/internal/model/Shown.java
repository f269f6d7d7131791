package org.robotui.uic.log.internal.model;

import java.util.List;
import java.util.Map;
import org.robotui.data.status.Severity;

/**
 * What the view shows; immutable.
 *
 * @param lines the rows, oldest first
 * @param filter what was asked for
 * @param counts kept entries of each severity, whatever is shown
 * @param origins who said something that is kept, by name
 * @param kept kept entries
 * @param total entries since the beginning or the last clearing
 * @param left entries that the filter has yet to look at
 * @param held entries that came during a pause and are not shown yet
 * @param rateHz entries a second, of the last seconds
 * @param dropped entries lost on the way
 * @param cleared whether the log was cleared
 */
public record Shown(List<LogLine> lines, LogFilter filter, Map<Severity, Integer> counts, List<OriginCount> origins,
    int kept, long total,
    long left, long held, double rateHz, long dropped, boolean cleared) {
  /** Nothing came yet. */
  public static final Shown NOTHING = new Shown(List.of(), LogFilter.ALL, Map.of(), List.of(), 0, 0, 0, 0, 0, 0, false);

  /** The row with an id, else the one after which it would stand; negative before the first. */
  public int indexOf(long id) {
    int low = 0;
    int high = lines.size() - 1;
    while (low <= high) {
      int middle = (low + high) >>> 1;
      if (lines.get(middle).id() <= id) {
        low = middle + 1;
      } else {
        high = middle - 1;
      }
    }
    return high;
  }
}
