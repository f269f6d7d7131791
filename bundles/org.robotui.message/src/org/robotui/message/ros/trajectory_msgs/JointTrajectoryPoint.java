package org.robotui.message.ros.trajectory_msgs;

import org.robotui.message.MessageType;

/**
 * What joints do at a time ({@code trajectory_msgs/JointTrajectoryPoint}).
 *
 * @param positions one a joint, radians or metres; or none
 * @param velocities one a joint, per second; or none
 * @param accelerations one a joint, per second squared; or none
 * @param effort one a joint, newton metres or newton; or none
 * @param timeFromStart nanoseconds since the start
 */
@MessageType("trajectory_msgs/JointTrajectoryPoint")
public record JointTrajectoryPoint(
    double[] positions,
    double[] velocities,
    double[] accelerations,
    double[] effort,
    long timeFromStart) {}
