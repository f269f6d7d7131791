/** Reads the recordings and models that lie beside the repository, where they lie. */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.testkit.recorded;
