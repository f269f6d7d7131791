package org.robotui.api.replay;

/**
 * Something that was found in a recording.
 *
 * @param track in which recording
 * @param range from when to when, in times of the recording; what happens at one time begins and ends there
 * @param over false where it had not ended when the recording did
 * @param words what was seen when it began, for example {@code battery.charge is 0.18}
 */
public record FoundEvent(TrackId track, TimeRange range, boolean over, String words) {}
