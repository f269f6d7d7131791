/**
 * What goes over a connection between two ports of YARP: headers, messages with their envelopes, acknowledgements.
 * Nothing here starts a thread; reading blocks as its stream does.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.yarp.wire;
