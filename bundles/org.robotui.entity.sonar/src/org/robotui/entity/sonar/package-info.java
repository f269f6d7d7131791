/**
 * Cones of sonars and infrared sensors.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.entity.sonar;
