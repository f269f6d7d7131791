/**
 * Calls to peers: how one ended ({@link org.robotui.net.call.Outcome}), how long to wait before the next attempt
 * ({@link org.robotui.net.call.Backoff}), and who waits for which answer ({@link org.robotui.net.call.OpenQuestions}).
 * Nothing here starts a thread; only asking blocks.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.net.call;
