/**
 * The way that a robot has gone, and how uncertain its place is.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.entity.odometry;
