/** Bytes that peers have packed. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.net.packed;
