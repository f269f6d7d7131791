package org.robotui.player.interfaces;

/**
 * Where a device is on its robot, and how large it is.
 *
 * @param pose on the robot
 * @param size of the device
 */
public record Body(Pose3d pose, Size3d size) {}
