package org.robotui.uic.plot.internal.model;

import java.util.OptionalDouble;
import org.robotui.api.replay.Timeline;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * The recordings that are plotted, at one moment.
 *
 * @param timeline moves them
 * @param span from the start of the earliest to the end of the latest, on the timeline
 * @param position where the timeline is
 * @param playing whether it goes on
 * @param progress how much of what is being read has been read, 0 to 1; none where all is there
 */
public record Replay(Timeline timeline, TimeSpan span, long position, boolean playing, OptionalDouble progress) {}
