/** Displays of scenes, driven without a scene. */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.testkit.display;
