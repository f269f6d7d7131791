/**
 * A connection to the broker of another application, by TCP. Threads come from whoever connects; listeners are told on
 * the reading thread and must not block.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roboframe.link;
