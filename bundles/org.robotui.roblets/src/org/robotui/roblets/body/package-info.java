/**
 * The bodymap: one tree of what all roblets of a robot say, with ages and a bounded history. Safe for all threads.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roblets.body;
