/**
 * Stand-ins for the core as an application sees it: for tests of windows and terminals without a robot.
 */
@org.osgi.annotation.versioning.Version("1.7.0")
package org.robotui.testkit.host;
