/**
 * The files that {@code package://} and {@code file://} name, which are looked for in given folders and nowhere else.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.urdf.pack;
