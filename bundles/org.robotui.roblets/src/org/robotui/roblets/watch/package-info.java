/**
 * Looks at the bodymap of a brain from outside, and asks the brain for something. It has one thread of its own.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roblets.watch;
