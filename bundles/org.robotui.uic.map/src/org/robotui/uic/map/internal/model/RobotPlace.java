package org.robotui.uic.map.internal.model;

import org.robotui.geometry.RigidTransform;

/**
 * Where a robot is.
 *
 * @param robot its name
 * @param fixedFromBase its place in the fixed frame
 * @param speed metres per second, 0 where it is not known
 */
public record RobotPlace(String robot, RigidTransform fixedFromBase, double speed) {}
