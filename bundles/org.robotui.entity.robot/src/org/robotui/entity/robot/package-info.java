/**
 * The body of a robot seen from above, and estimates of where it is.
 */
@org.osgi.annotation.versioning.Version("1.2.0")
package org.robotui.entity.robot;
