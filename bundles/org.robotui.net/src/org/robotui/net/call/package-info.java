/**
 * Calls to peers: how one ended ({@link org.robotui.net.call.Outcome}), and how long to wait before the next attempt
 * ({@link org.robotui.net.call.Backoff}). Nothing here blocks or starts a thread.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.net.call;
