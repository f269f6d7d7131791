package org.robotui.message.roboframe;

import org.robotui.message.MessageType;

/**
 * How a robot shall move ({@code roboframe/Velocity}).
 *
 * @param forward speed ahead, metres per second
 * @param left speed to the left, metres per second
 * @param turn turning to the left, radians per second
 */
@MessageType("roboframe/Velocity")
public record VelocityStreamable(double forward, double left, double turn) {}
