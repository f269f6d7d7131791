package org.robotui.rfic.recording.internal.send;

import java.time.Duration;

/**
 * How a recording is sent.
 *
 * @param rate how much faster than it was recorded
 * @param loop whether it begins again at its end
 * @param delay for those who listen to find what is announced, before the first message
 * @param waits whether somebody has to listen to each topic before that
 */
public record SendPace(double rate, boolean loop, Duration delay, boolean waits) {}
