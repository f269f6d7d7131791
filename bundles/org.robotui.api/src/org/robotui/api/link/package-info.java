/**
 * The state of the link to a robot.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.link;
