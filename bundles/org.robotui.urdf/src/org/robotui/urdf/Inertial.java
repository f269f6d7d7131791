package org.robotui.urdf;

import org.robotui.geometry.RigidTransform;

/**
 * The mass of a link.
 *
 * @param linkFromCenter where the centre of mass is, and how the axes of the moments are turned
 * @param mass kilograms
 * @param ixx moment about x, kilogram square metres
 * @param iyy moment about y
 * @param izz moment about z
 * @param ixy product of inertia
 * @param ixz product of inertia
 * @param iyz product of inertia
 */
public record Inertial(
    RigidTransform linkFromCenter, double mass, double ixx, double iyy, double izz, double ixy, double ixz,
    double iyz) {}
