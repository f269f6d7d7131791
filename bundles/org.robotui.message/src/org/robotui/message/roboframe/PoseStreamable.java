package org.robotui.message.roboframe;

import org.robotui.message.MessageType;

/**
 * Where something is on a plane ({@code roboframe/Pose}).
 *
 * @param stamp when it was measured, nanoseconds by the clock of the application
 * @param frame the frame
 * @param x metres in the frame
 * @param y metres in the frame
 * @param heading radians in the frame
 */
@MessageType("roboframe/Pose")
public record PoseStreamable(long stamp, String frame, double x, double y, double heading) {}
