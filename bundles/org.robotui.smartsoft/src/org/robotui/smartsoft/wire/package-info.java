/**
 * Frames of ACE/SmartSoft, as they go between components and their naming service, and between components. Nothing here
 * starts a thread; reading blocks as its stream does. Lengths are bounded before anything is allocated for them.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.smartsoft.wire;
