package org.robotui.rfic.recording.internal.compare;

import org.robotui.api.replay.TimeRange;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/**
 * One of two recordings.
 *
 * @param name of its file, for users
 * @param history all of it
 * @param range what of it is compared, in its own times
 * @param offset what is added to its times
 */
public record ComparedFile(String name, SearchableHistory history, TimeRange range, long offset) {}
