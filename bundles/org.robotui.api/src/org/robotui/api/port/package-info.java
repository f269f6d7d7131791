/**
 * Typed ports: streams out of a robot, commands into it, calls with replies, and browsing of what it has.
 */
@org.osgi.annotation.versioning.Version("1.7.0")
package org.robotui.api.port;
