/**
 * Applications: modules that read and write the channels of a blackboard, each on a thread of its own, put together
 * with the connectors by which they reach other applications.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roboframe.app;
