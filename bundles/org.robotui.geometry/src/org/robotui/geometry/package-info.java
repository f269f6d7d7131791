/**
 * Rigid body geometry in SI units: metres, radians, right-handed axes, quaternions as (x, y, z, w).
 *
 * <p>Transforms are named {@code target_from_source}: applied to a point given in the source frame they answer the same
 * point in the target frame, so that {@code aFromB.times(bFromC)} is {@code aFromC}.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.geometry;
