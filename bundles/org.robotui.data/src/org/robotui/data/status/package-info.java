/** How a robot is doing: diagnostics of its parts, and what its programs say. */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.data.status;
