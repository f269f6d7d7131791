/**
 * Stand-ins for what core gives to a view, for tests: inputs that hold what a test puts in, outputs that keep what a
 * view sends, an authority with a lease and a latched stop, pictures. Safe for all threads, as the real ones are.
 */
@org.osgi.annotation.versioning.Version("1.15.0")
package org.robotui.testkit;
