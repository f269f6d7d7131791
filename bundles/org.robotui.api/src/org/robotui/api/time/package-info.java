/**
 * Clocks: every robot user interface has one, which may be simulated and may jump back.
 */
@org.osgi.annotation.versioning.Version("1.2.0")
package org.robotui.api.time;
