/**
 * Bumpers around a robot.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.entity.bumper;
