package org.robotui.message.roboframe;

import org.robotui.message.MessageType;

/**
 * Where a robot shall go ({@code roboframe/Target}).
 *
 * @param frame the frame
 * @param x metres in the frame
 * @param y metres in the frame
 * @param heading radians in the frame
 */
@MessageType("roboframe/Target")
public record TargetStreamable(String frame, double x, double y, double heading) {}
