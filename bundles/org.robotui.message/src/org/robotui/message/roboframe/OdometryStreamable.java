package org.robotui.message.roboframe;

import org.robotui.message.MessageType;

/**
 * Where wheels say that a robot is, and how fast it moves ({@code roboframe/Odometry}).
 *
 * @param stamp when it was measured, nanoseconds by the clock of the application
 * @param frame the frame of the odometry
 * @param body the frame of the robot's base
 * @param x metres in the frame
 * @param y metres in the frame
 * @param heading radians in the frame
 * @param forward speed ahead, metres per second
 * @param left speed to the left, metres per second
 * @param turn turning to the left, radians per second
 */
@MessageType("roboframe/Odometry")
public record OdometryStreamable(long stamp, String frame, String body, double x, double y, double heading,
    double forward, double left, double turn) {}
