package org.robotui.recording;

import java.util.function.Predicate;

/**
 * A part of a recording.
 *
 * @param interval the log times
 * @param channels which channels
 */
public record RecordingPart(RecordingInterval interval, Predicate<RecordedChannel> channels) {

  /** All of a recording. */
  public static final RecordingPart ALL = new RecordingPart(RecordingInterval.ALWAYS, channel -> true);
}
