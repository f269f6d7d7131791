package org.robotui.api.replay;

/**
 * A time that a user noted.
 *
 * @param time nanoseconds since 1970 on the timeline
 * @param note the user's words, may be empty
 */
public record Bookmark(long time, String note) {}
