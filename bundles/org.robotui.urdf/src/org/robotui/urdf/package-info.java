/**
 * Models of robots from URDF and SRDF as immutable records, and where their links are. Metres, radians, kilograms. The
 * texts may come from anybody: their size, depth and counts are bounded, and no document can make the reader open
 * another one.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.urdf;
