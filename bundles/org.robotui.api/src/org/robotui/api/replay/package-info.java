/**
 * Recordings as time: the one timeline on which all open recordings lie, what plays on it, how it is moved, all that a
 * recording has of a stream, when something was so, and how far two recordings are apart.
 */
@org.osgi.annotation.versioning.Version("1.4.0")
package org.robotui.api.replay;
