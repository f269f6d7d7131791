/**
 * Pictures as frame grabbers of YARP send them.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.yarp.image;
