package org.robotui.urdf;

import org.robotui.geometry.RigidTransform;

/**
 * What of a link can touch things.
 *
 * @param name may be empty
 * @param linkFromForm where the form is in the link
 * @param geometry the form
 */
public record Collision(String name, RigidTransform linkFromForm, Geometry geometry) {}
