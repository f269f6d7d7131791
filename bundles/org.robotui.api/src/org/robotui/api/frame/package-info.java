/**
 * Coordinate frames of robots.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.frame;
