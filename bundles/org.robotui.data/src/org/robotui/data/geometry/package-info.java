/**
 * Where things are and how they move: poses, footprints, velocities, forces and torques, and transforms between frames.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.data.geometry;
