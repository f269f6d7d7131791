/**
 * Ports of YARP: our own that listen and say, connections to those of others for questions and for commands, and how
 * others' ports are told whom to connect to. All is safe for all threads.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.yarp.port;
