/** What programs of robots draw in space, and what users do with it. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.data.marker;
