package org.robotui.rfic.recording.internal.compare;

import java.util.List;

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
    List<String> problems) {}
