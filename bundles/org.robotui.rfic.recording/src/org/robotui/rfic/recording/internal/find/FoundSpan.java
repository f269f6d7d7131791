package org.robotui.rfic.recording.internal.find;

import org.robotui.api.replay.TimeRange;

/**
 * A time at which a condition held.
 *
 * @param range from when to when, in times of the recording
 * @param over false where it still held at the end
 * @param words what was seen when it began
 */
public record FoundSpan(TimeRange range, boolean over, String words) {}
