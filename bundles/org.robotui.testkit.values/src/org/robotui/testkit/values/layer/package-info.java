/** Layers of maps in a test's hands. */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.testkit.values.layer;
