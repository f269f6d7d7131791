/**
 * YARP's name server: how it is asked, and a small one of our own. Asking blocks, at most as long as it is told to; all
 * is safe for all threads.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.yarp.name;
