/**
 * Frames of IPC, as they go between modules and a central, and between modules. Nothing here starts a thread; reading
 * blocks as its stream does. Lengths are bounded before anything is allocated for them.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.carmen.wire;
