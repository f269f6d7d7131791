/**
 * A laser scan: echoes and the space that the beams crossed.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.entity.laserscan;
