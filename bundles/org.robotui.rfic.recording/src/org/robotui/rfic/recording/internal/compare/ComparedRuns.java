package org.robotui.rfic.recording.internal.compare;

import java.util.List;
import org.robotui.api.replay.ComparisonReport;

/**
 * What comparing came to.
 *
 * @param pairs how many values belong together
 * @param first how many values the first recording has
 * @param second how many the other has
 * @param shift what was added to times of the second recording, in nanoseconds; 0 where they were paired by the way
 * @param errors all of them
 * @param problems what could not be read, sentences for users
 */
public record ComparedRuns(int pairs, int first, int second, long shift, List<ErrorSeries> errors,
    List<String> problems) {
  /**
   * The same for those who do not know files.
   *
   * @param offset what is added to times of the first recording, in nanoseconds
   * @return all of it
   */
  public ComparisonReport report(long offset) {
    return new ComparisonReport(pairs, first, second, errors.stream().map(each -> each.compared(offset)).toList(),
        problems);
  }
}
