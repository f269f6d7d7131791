/** Where a robot is in its map, and where it goes: odometry, estimates, maps, paths and goals. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.data.navigation;
