package org.robotui.message.roboframe;

import org.robotui.message.MessageType;

/**
 * One sweep of a planar scanner ({@code roboframe/Scan}).
 *
 * @param stamp when it was taken, nanoseconds by the clock of the application
 * @param frame the frame in whose x-y plane the rays lie
 * @param start angle of the first ray, radians
 * @param step from ray to ray, radians
 * @param nearest shortest distance that is measured, metres
 * @param farthest longest distance that is measured, metres
 * @param ranges a distance for each ray, metres; outside of the limits there was no echo
 */
@MessageType("roboframe/Scan")
public record ScanStreamable(long stamp, String frame, float start, float step, float nearest, float farthest,
    float[] ranges) {}
