package org.robotui.urdf;

import java.util.Optional;
import org.robotui.geometry.RigidTransform;

/**
 * What is seen of a link.
 *
 * @param name may be empty
 * @param linkFromForm where the form is in the link
 * @param geometry the form
 * @param surface how it looks; none where the file's own colours hold
 */
public record Visual(String name, RigidTransform linkFromForm, Geometry geometry, Optional<Surface> surface) {}
