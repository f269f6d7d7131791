/**
 * Channels of an application: keys with a type each, whose newest value stands on a blackboard, and the router that
 * shares them with other applications. Safe for all threads.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roboframe.board;
