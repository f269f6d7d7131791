/**
 * What brokers of RoboFrame applications say to each other, and how that becomes bytes. The wire is ours, and is
 * described in {@code docs/roboframe.md}: nothing is known of that of the original framework.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roboframe.wire;
