/**
 * Recordings as time: the one timeline on which all open recordings lie, what plays on it, how it is moved, and all
 * that a recording has of a stream.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.replay;
