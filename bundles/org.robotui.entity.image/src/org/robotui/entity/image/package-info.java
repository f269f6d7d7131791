/**
 * Pictures of a robot's cameras as a window can paint them. Decoding is pure, needs no display, and takes bytes from
 * the network as hostile: sizes are known before memory is taken.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.entity.image;
