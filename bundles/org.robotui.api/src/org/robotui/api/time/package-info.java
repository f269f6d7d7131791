/**
 * Clocks: every robot user interface has one, which may be simulated and may jump back; how often something comes, and
 * when a value is too old.
 */
@org.osgi.annotation.versioning.Version("1.3.0")
package org.robotui.api.time;
