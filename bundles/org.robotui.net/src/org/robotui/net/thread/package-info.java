/**
 * Threads of a library: started from the factory of its owner, named, and waited for in a bounded time when the library
 * is closed ({@link org.robotui.net.thread.Workers}), also by a thread that was interrupted
 * ({@link org.robotui.net.thread.Uninterruptibles}). Deadlines are times of {@link System#nanoTime}.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.net.thread;
