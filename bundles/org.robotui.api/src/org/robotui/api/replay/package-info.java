/**
 * Recordings as time: the one timeline on which all open recordings lie, what plays on it, and how it is moved.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.api.replay;
