/** Pictures, raw and compressed, and the calibration of the cameras that take them. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.data.image;
