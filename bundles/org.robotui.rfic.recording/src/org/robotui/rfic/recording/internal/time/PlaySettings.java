package org.robotui.rfic.recording.internal.time;

/**
 * How a recording comes to the timeline.
 *
 * @param offset what is added to its times, nanoseconds
 * @param plays whether it plays when it is opened
 * @param loops whether it begins again at its end
 */
public record PlaySettings(long offset, boolean plays, boolean loops) {}
