/**
 * Datagrams between roblets, their brain and who watches it, and what may be said of their order. Nothing here starts a
 * thread or blocks.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roblets.wire;
